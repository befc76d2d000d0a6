// SPDX-License-Identifier: MIT
#include "flatland/curve/expression.h"

#include <charconv>
#include <numbers>
#include <utility>

namespace flatland {

class ExpressionParser {
 public:
  ExpressionParser(const std::string& text, const Expression::Constants& constants, bool variable)
      : text_(text), constants_(constants), variable_(variable) {}

  Expression::Result run() {
    try {
      if (text_.size() > Expression::kLongestText) {
        fail(Expression::kLongestText, "the formula is longer than " +
                                           std::to_string(Expression::kLongestText) +
                                           " characters");
      }
      sum();
      skipBlanks();
      if (at_ < text_.size()) failHere(text_[at_] == ')' ? "there is no ( for this )" : expected());
      return {std::move(result_), {}};
    } catch (const ExpressionError& error) {
      return {std::nullopt, error};
    }
  }

  struct Function {
    const char* name;
    Expression::Op op;
    int arguments;
  };
  static const std::vector<Function>& functions();

 private:
  using Op = Expression::Op;

  // Exceptions stay inside run().
  [[noreturn]] void fail(std::size_t byte, const std::string& reason) const {
    int column = 1;
    for (std::size_t i = 0; i < byte && i < text_.size(); ++i) {
      if ((static_cast<unsigned char>(text_[i]) & 0xC0U) != 0x80U) ++column;
    }
    throw ExpressionError{column, reason};
  }
  [[noreturn]] void failHere(const std::string& reason) const { fail(at_, reason); }

  /// The character at the position, whole also where it has several bytes.
  std::string character() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    return text_.substr(at_, end - at_);
  }

  std::string expected() const {
    if (isLetter(text_[at_]) || isDigit(text_[at_]) || text_[at_] == '(') {
      return "an operator is missing before \"" + character() + "\"; a product is written 2*t";
    }
    return "\"" + character() + "\" cannot stand here";
  }

  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  static bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  }

  void skipBlanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skipBlanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void add(Op op, int operands, double constant = 0.0) {
    result_.program_.push_back({op, constant});
    stack_ += 1 - static_cast<std::size_t>(operands);
    if (stack_ > Expression::kDeepestStack) failHere("the formula is nested too deeply");
  }

  // Every recursion passes here or through signedPower.
  struct Nesting {
    explicit Nesting(ExpressionParser& parser) : parser_(parser) {
      constexpr int kDeepest = 200;
      if (++parser_.depth_ > kDeepest) parser_.failHere("the formula is nested too deeply");
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    ExpressionParser& parser_;
  };

  void sum() {
    const Nesting nesting(*this);
    product();
    while (true) {
      if (take('+')) {
        product();
        add(Op::Add, 2);
      } else if (take('-')) {
        product();
        add(Op::Subtract, 2);
      } else {
        return;
      }
    }
  }

  void product() {
    signedPower();
    while (true) {
      if (take('*')) {
        signedPower();
        add(Op::Multiply, 2);
      } else if (take('/')) {
        signedPower();
        add(Op::Divide, 2);
      } else {
        return;
      }
    }
  }

  void signedPower() {
    const Nesting nesting(*this);
    if (take('-')) {
      signedPower();
      add(Op::Negate, 1);
    } else if (take('+')) {
      signedPower();
    } else {
      primary();
      if (take('^')) {
        signedPower();
        add(Op::Power, 2);
      }
    }
  }

  void primary() {
    skipBlanks();
    if (at_ >= text_.size()) failHere("something is missing here");
    const char c = text_[at_];
    if (isDigit(c) || c == '.') {
      number();
    } else if (isLetter(c)) {
      name();
    } else if (take('(')) {
      sum();
      if (!take(')')) failHere(at_ < text_.size() ? expected() : "a ) is missing");
    } else {
      failHere("\"" + character() + "\" cannot stand here");
    }
  }

  void number() {
    double value = 0.0;
    const char* first = text_.data() + at_;
    const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) failHere("this number is out of range");
    if (error != std::errc()) failHere("this is not a number");
    at_ += static_cast<std::size_t>(end - first);
    add(Op::Constant, 0, value);
  }

  void name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (isLetter(text_[at_]) || isDigit(text_[at_]))) ++at_;
    const std::string word = text_.substr(start, at_ - start);
    for (const Function& function : functions()) {
      if (word == function.name) return call(function, start);
    }
    if (word == "t") {
      if (!variable_) fail(start, "t cannot stand here: the domain of t must not depend on it");
      return add(Op::Variable, 0);
    }
    if (word == "pi") return add(Op::Constant, 0, std::numbers::pi);
    if (word == "e") return add(Op::Constant, 0, std::numbers::e);
    const auto constant = constants_.find(word);
    if (constant != constants_.end()) return add(Op::Constant, 0, constant->second);
    skipBlanks();
    const bool called = at_ < text_.size() && text_[at_] == '(';
    fail(start, "\"" + word + "\" is not known: " +
                    (called ? "there is no such function" : "neither t, pi, e nor a constant"));
  }

  void call(const Function& function, std::size_t start) {
    if (!take('(')) fail(start, std::string(function.name) + " needs its argument in ( )");
    for (int i = 0; i < function.arguments; ++i) {
      if (i > 0 && !take(',')) {
        fail(start, std::string(function.name) + " needs two arguments with a comma between them");
      }
      sum();
    }
    if (!take(')')) {
      skipBlanks();
      if (at_ < text_.size() && text_[at_] == ',') {
        failHere(std::string(function.name) + " takes " +
                 (function.arguments == 1 ? "one argument" : "two arguments") +
                 "; a decimal is written with a point");
      }
      failHere(at_ < text_.size() ? expected() : "a ) is missing");
    }
    add(function.op, function.arguments);
  }

  const std::string& text_;
  const Expression::Constants& constants_;
  bool variable_;
  std::size_t at_ = 0;
  std::size_t stack_ = 0;
  int depth_ = 0;
  Expression result_;
};

const std::vector<ExpressionParser::Function>& ExpressionParser::functions() {
  static const std::vector<Function> known = {
      {"sin", Op::Sin, 1},     {"cos", Op::Cos, 1},     {"tan", Op::Tan, 1},
      {"asin", Op::Asin, 1},   {"acos", Op::Acos, 1},   {"atan", Op::Atan, 1},
      {"sinh", Op::Sinh, 1},   {"cosh", Op::Cosh, 1},   {"tanh", Op::Tanh, 1},
      {"asinh", Op::Asinh, 1}, {"acosh", Op::Acosh, 1}, {"atanh", Op::Atanh, 1},
      {"exp", Op::Exp, 1},     {"log", Op::Log, 1},     {"ln", Op::Log, 1},
      {"log10", Op::Log10, 1}, {"sqrt", Op::Sqrt, 1},   {"abs", Op::Abs, 1},
      {"pow", Op::Power, 2},   {"atan2", Op::Atan2, 2}, {"hypot", Op::Hypot, 2},
  };
  return known;
}

Expression::Result Expression::parse(const std::string& text, const Constants& constants,
                                     bool variable) {
  return ExpressionParser(text, constants, variable).run();
}

std::optional<std::string> Expression::whyNotAName(const std::string& name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  if (name.empty() || !letter(name.front())) return "a name begins with a letter";
  for (const char c : name) {
    if (!letter(c) && !(c >= '0' && c <= '9')) return "a name has only letters a-z, digits and _";
  }
  constexpr std::size_t kLongestName = 64;
  if (name.size() > kLongestName) return "the name is longer than 64 letters";
  bool taken = name == "t" || name == "pi" || name == "e";
  for (const auto& function : ExpressionParser::functions()) taken = taken || name == function.name;
  if (taken) return "the name is taken already";
  return std::nullopt;
}

template <int N>
Taylor<N> Expression::at(const Taylor<N>& t) const {
  std::array<Taylor<N>, kDeepestStack> stack;
  std::size_t size = 0;
  for (const Step& step : program_) {
    switch (step.op) {
      case Op::Constant:
        stack[size++] = Taylor<N>(step.constant);
        continue;
      case Op::Variable:
        stack[size++] = t;
        continue;
      default:
        break;
    }
    Taylor<N>& a = stack[size - 1];
    switch (step.op) {
      case Op::Negate:
        a = -a;
        continue;
      case Op::Sin:
        a = sin(a);
        continue;
      case Op::Cos:
        a = cos(a);
        continue;
      case Op::Tan:
        a = tan(a);
        continue;
      case Op::Asin:
        a = asin(a);
        continue;
      case Op::Acos:
        a = acos(a);
        continue;
      case Op::Atan:
        a = atan(a);
        continue;
      case Op::Sinh:
        a = sinh(a);
        continue;
      case Op::Cosh:
        a = cosh(a);
        continue;
      case Op::Tanh:
        a = tanh(a);
        continue;
      case Op::Asinh:
        a = asinh(a);
        continue;
      case Op::Acosh:
        a = acosh(a);
        continue;
      case Op::Atanh:
        a = atanh(a);
        continue;
      case Op::Exp:
        a = exp(a);
        continue;
      case Op::Log:
        a = log(a);
        continue;
      case Op::Log10:
        a = std::numbers::log10e * log(a);
        continue;
      case Op::Sqrt:
        a = sqrt(a);
        continue;
      case Op::Abs:
        a = abs(a);
        continue;
      default:
        break;
    }
    const Taylor<N> b = stack[--size];
    Taylor<N>& first = stack[size - 1];
    switch (step.op) {
      case Op::Add:
        first = first + b;
        break;
      case Op::Subtract:
        first = first - b;
        break;
      case Op::Multiply:
        first = first * b;
        break;
      case Op::Divide:
        first = first / b;
        break;
      case Op::Power:
        first = pow(first, b);
        break;
      case Op::Atan2:
        first = atan2(first, b);
        break;
      case Op::Hypot:
        first = sqrt(first * first + b * b);
        break;
      default:
        break;
    }
  }
  return stack[0];
}

template Taylor<0> Expression::at(const Taylor<0>& t) const;
template Taylor<4> Expression::at(const Taylor<4>& t) const;

}  // namespace flatland
