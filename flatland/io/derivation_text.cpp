// SPDX-License-Identifier: MIT
#include "flatland/io/derivation_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "flatland/io/number_text.h"

namespace flatland {

namespace {

std::string shortNumber(double value) {
  std::array<char, 32> buffer;
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return {buffer.data(), static_cast<std::size_t>(length)};
}

std::string list(const StepValue& value, const char* between, bool exact) {
  std::string text;
  for (int i = 0; i < value.count(); ++i) {
    const double entry = value.entries[static_cast<std::size_t>(i)];
    if (i > 0) text += between;
    text += exact ? numberText(std::optional(entry), "null") : shortNumber(entry);
  }
  return text;
}

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

/// At the step size that serves the corrected form best.
std::string bestDifference(const DerivationRow& row, bool printed, const std::string& absent) {
  if (row.sweep.empty()) return absent;
  const auto best = std::min_element(
      row.sweep.begin(), row.sweep.end(),
      [](const StepDifference& a, const StepDifference& b) { return a.corrected < b.corrected; });
  return numberText(printed ? best->printed : std::optional(best->corrected), absent);
}

std::string sidesJson(const DerivationStepText& text, const StepSides& sides, bool printed) {
  const auto name = [printed](std::string_view usual, std::string_view other) {
    return quoted(printed ? other : usual);
  };
  return "{\"left\": {\"is\": " + name(text.left, text.printedLeft) + ", \"values\": [" +
         list(sides.left, ", ", true) +
         "]}, \"right\": {\"is\": " + name(text.right, text.printedRight) + ", \"values\": [" +
         list(sides.right, ", ", true) + "]}, \"residual\": " + numberText(sides.residual) +
         ", \"apart\": " + numberText(sides.apart) + "}";
}

std::string sweepJson(const std::vector<StepDifference>& sweep) {
  std::string text = "[";
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    text += (i == 0 ? "" : ", ") + std::string("[") + numberText(sweep[i].h) + ", " +
            numberText(std::optional(sweep[i].corrected), "null");
    if (sweep[i].printed) text += ", " + numberText(sweep[i].printed, "null");
    text += "]";
  }
  return text + "]";
}

std::string csvRow(const DerivationRow& row, const StepSides* sides, bool printed) {
  const DerivationStepText& text = row.text;
  return std::string(text.id) + "," + (printed ? "printed" : "corrected") + "," +
         wordsFor(row.reading.answer) + "," + (sides ? list(sides->left, " ", true) : "") + "," +
         (sides ? list(sides->right, " ", true) : "") + "," +
         (sides ? numberText(sides->residual) : "") + "," +
         (sides ? numberText(sides->apart) : "") + "," + bestDifference(row, printed, "") + "\r\n";
}

void addSides(std::string& text, const char* variant, std::string_view leftName,
              std::string_view rightName, const StepSides& sides) {
  text += "  " + std::string(variant) + std::string(leftName) + " = " +
          list(sides.left, "  ", false) + "\n";
  text += "              " + std::string(rightName) + " = " + list(sides.right, "  ", false) + "\n";
  text += "              residual " + shortNumber(sides.residual);
  // Against 0 the relative distance is 1 for any rounding: it says nothing.
  text += rightName == "0" ? ": zero but for rounding, as for any unit vector\n"
                           : ", sides apart by " + shortNumber(sides.apart) + "\n";
}

}  // namespace

std::vector<DerivationRow> derivationRows(const DerivationPlace& place) {
  std::vector<DerivationRow> rows;
  for (int i = 0; i < kDerivationStepCount; ++i) {
    const auto step = static_cast<DerivationStep>(i);
    rows.push_back({textOf(step), readStep(step, place), stepSizeSweep(step, place)});
  }
  return rows;
}

std::string wordsFor(StepAnswer answer) {
  switch (answer) {
    case StepAnswer::Evaluated:
      return "evaluated";
    case StepAnswer::NoTangent:
      return "no tangent";
    case StepAnswer::Silhouette:
      return "silhouette";
    case StepAnswer::NoNormal:
      return "no normal";
    case StepAnswer::NoDirection:
      return "no direction";
  }
  return {};
}

std::string derivationStepsJson(const std::vector<DerivationRow>& rows) {
  std::string text = "[\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const DerivationRow& row = rows[i];
    const DerivationStepText& names = row.text;
    text += "    {\"id\": " + quoted(names.id) + ", \"title\": " + quoted(names.title) +
            ", \"answer\": " + quoted(wordsFor(row.reading.answer));
    if (row.reading.corrected) {
      text += ",\n     \"corrected\": " + sidesJson(names, *row.reading.corrected, false);
    }
    if (row.reading.printed) {
      text += ",\n     \"printed\": " + sidesJson(names, *row.reading.printed, true);
    }
    if (!row.sweep.empty()) {
      text += ",\n     \"stepSizes\": {\"h\": " + quoted(names.step) +
              ", \"columns\": [\"h\", \"corrected\"" +
              (names.isMisprinted() ? ", \"printed\"" : "") +
              "], \"rows\": " + sweepJson(row.sweep) + "}";
    }
    text += i + 1 < rows.size() ? "},\n" : "}\n";
  }
  return text + "  ]";
}

std::string derivationToJson(const std::vector<DerivationRow>& rows) {
  return "{\n  \"steps\": " + derivationStepsJson(rows) + "\n}\n";
}

std::string derivationToCsv(const std::vector<DerivationRow>& rows) {
  std::string text = "step,variant,answer,left,right,residual,apart,bestDifference\r\n";
  for (const DerivationRow& row : rows) {
    const auto sides = [](const std::optional<StepSides>& s) { return s ? &*s : nullptr; };
    text += csvRow(row, sides(row.reading.corrected), false);
    if (row.text.isMisprinted()) text += csvRow(row, sides(row.reading.printed), true);
  }
  return text;
}

std::string derivationToText(const std::vector<DerivationRow>& rows) {
  std::string text;
  for (const DerivationRow& row : rows) {
    const DerivationStepText& names = row.text;
    text += "(" + std::string(names.id) + ") " + std::string(names.title) + "\n";
    if (row.reading.answer != StepAnswer::Evaluated) {
      text += "  no answer:  " + wordsFor(row.reading.answer) + "\n";
    }
    if (row.reading.corrected) {
      addSides(text, names.isMisprinted() ? "corrected:  " : "            ", names.left,
               names.right, *row.reading.corrected);
    }
    if (row.reading.printed) {
      addSides(text, "as printed: ", names.printedLeft, names.printedRight, *row.reading.printed);
    }
    if (!row.sweep.empty()) {
      text += "  best difference quotient: corrected to " + bestDifference(row, false, "-");
      if (names.isMisprinted()) text += ", as printed to " + bestDifference(row, true, "-");
      text += "\n";
    }
    text += "\n";
  }
  return text;
}

}  // namespace flatland
