// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/formula_editor.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <utility>

#include "flatland/io/number_text.h"
#include "ui/commands/curve_commands.h"
#include "ui/model/core_words.h"

namespace flatland::ui {

std::optional<Expression::Constants> constantsFrom(const QString& text) {
  Expression::Constants constants;
  for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
    if (part.trimmed().isEmpty()) continue;
    const QStringList sides = part.split('=');
    if (sides.size() != 2) return std::nullopt;
    bool isNumber = false;
    const double value = sides[1].trimmed().toDouble(&isNumber);
    if (!isNumber) return std::nullopt;
    constants[sides[0].trimmed().toStdString()] = value;
  }
  return constants;
}

QString constantsText(const Expression::Constants& constants) {
  QStringList parts;
  for (const auto& [name, value] : constants) {
    parts += QString::fromStdString(name + " = " + numberText(value));
  }
  return parts.join(QStringLiteral(", "));
}

FormulaEditor::FormulaEditor(Document& document, std::size_t curve, QWidget* parent)
    : QWidget(parent), document_(document), curve_(curve) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(2);
  using Of = FormulaError::Field;
  fields_ = {
      addField(Of::X, "x", tr("&x(t)"), tr("A formula in t, such as cos(t) * (1 + a*cos(3*t))")),
      addField(Of::Y, "y", tr("&y(t)"), tr("A formula in t, such as sin(t)^3")),
      addField(Of::From, "from", tr("t &from"), tr("Where t begins: a formula without t")),
      addField(Of::To, "to", tr("t &to"), tr("Where t ends: a formula without t, such as 2*pi")),
      addField(Of::Constants, "constants", tr("&with"),
               tr("Named numbers, such as a = 0.3, b = 2"))};
  refresh();
}

const FormulaCurve& FormulaEditor::shape() const {
  return std::get<FormulaCurve>(document_.scene().curves[curve_].shape);
}

bool FormulaEditor::isThere() const {
  const auto& curves = document_.scene().curves;
  if (curve_ >= curves.size()) return false;
  const auto* formula = std::get_if<FormulaCurve>(&curves[curve_].shape);
  return formula && formula->typed();
}

FormulaEditor::~FormulaEditor() {
  // A field that goes while it has the focus tells that editing has finished.
  for (const Field& field : fields_) field.edit->disconnect(this);
}

FormulaEditor::Field FormulaEditor::addField(FormulaError::Field of, const QString& id,
                                             const QString& label, const QString& tip) {
  auto* form = static_cast<QFormLayout*>(layout());
  auto* edit = new QLineEdit(this);
  edit->setObjectName("curve.formula." + id);
  edit->setToolTip(tip);
  auto* error = new QLabel(this);
  error->setObjectName("curve.error." + id);
  error->setWordWrap(true);
  error->hide();
  form->addRow(label, edit);
  form->addRow(QString(), error);
  connect(edit, &QLineEdit::textEdited, this, [this, of] { typed(of); });
  connect(edit, &QLineEdit::editingFinished, this, &FormulaEditor::finish);
  return {edit, error};
}

void FormulaEditor::typed(FormulaError::Field edited) {
  isWrong_ = true;
  for (const Field& field : fields_) field.error->hide();
  const auto text = [this](std::size_t i) { return fields_[i].edit->text().toStdString(); };
  const auto constants = constantsFrom(fields_[4].edit->text());
  if (!constants) {
    showError({FormulaError::Field::Constants, 0,
               tr("Write a = 0.3, b = 2: names, numbers, commas.").toStdString()});
    return;
  }
  const TypedFormula formula{text(0), text(1), text(2), text(3), *constants};
  const FormulaCurve::Result result = FormulaCurve::make(formula, shape().at());
  if (!result.curve) {
    // A domain that ends before it begins is the fault of the end that was typed.
    FormulaError error = result.error;
    const bool isDomain = error.field == FormulaError::Field::To && error.column == 0;
    if (isDomain && edited == FormulaError::Field::From) error.field = edited;
    showError(error);
    return;
  }
  isWrong_ = false;
  shown_ = formula;
  if (gesture_ == kNoGesture) {
    gesture_ = document_.newGesture();
    before_ = shape();
  }
  document_.push(std::make_unique<ReplaceCurve>(document_, curve_, *result.curve,
                                                tr("type formula"), gesture_));
}

void FormulaEditor::finish() {
  const int gesture = std::exchange(gesture_, kNoGesture);
  // Undo, or another curve in this place, may have come between.
  if (!isWrong_ || gesture == kNoGesture || !isThere() || !(*shape().typed() == shown_)) return;
  shown_ = *before_->typed();  // the fields keep what was typed
  document_.push(
      std::make_unique<ReplaceCurve>(document_, curve_, *before_, tr("type formula"), gesture));
}

void FormulaEditor::showError(const FormulaError& error) {
  const Field& field = fields_[static_cast<std::size_t>(error.field)];
  const QString reason = coreWords(error.reason);
  QString text = reason;
  int indent = 0;
  if (error.column > 0) {
    // The arrow stands under the character, unless that leaves too little room for the words.
    const QString before = field.edit->text().left(error.column - 1);
    indent = std::min(field.edit->fontMetrics().horizontalAdvance(before), field.edit->width() / 3);
    text = QStringLiteral("\u25b2 ") + tr("column %1: %2").arg(error.column).arg(reason);
  }
  field.error->setIndent(indent);
  field.error->setText(text);
  field.error->show();
}

void FormulaEditor::refresh() {
  const TypedFormula& formula = *shape().typed();
  if (formula == shown_) return;
  shown_ = formula;
  gesture_ = kNoGesture;
  isWrong_ = false;
  const std::array<QString, 5> texts = {
      QString::fromStdString(formula.x), QString::fromStdString(formula.y),
      QString::fromStdString(formula.from), QString::fromStdString(formula.to),
      constantsText(formula.constants)};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    fields_[i].error->hide();
    if (fields_[i].edit->text() != texts[i]) fields_[i].edit->setText(texts[i]);
  }
}

}  // namespace flatland::ui
