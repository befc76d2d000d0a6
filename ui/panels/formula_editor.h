// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "ui/model/document.h"

class QLabel;
class QLineEdit;

namespace flatland::ui {

/// x(t) and y(t) as typed, the domain and named constants. The curve follows while the text makes
/// sense; what does not is said below its field, from where the mistake is, and the curve stays.
/// What is typed until Enter or until the field is left is one step of undo, and none if it makes
/// no sense in the end: then the curve is as it was before.
class FormulaEditor : public QWidget {
  Q_OBJECT

 public:
  /// Precondition: the curve is a typed one, and stays so while the editor lives.
  FormulaEditor(Document& document, std::size_t curve, QWidget* parent = nullptr);
  ~FormulaEditor() override;

  /// Shows what the document holds, unless it is what was typed here.
  void refresh();

 private:
  struct Field {
    QLineEdit* edit;
    QLabel* error;
  };
  const FormulaCurve& shape() const;
  bool isThere() const;
  Field addField(FormulaError::Field of, const QString& id, const QString& label,
                 const QString& tip);
  void typed(FormulaError::Field edited);
  void finish();
  void showError(const FormulaError& error);

  Document& document_;
  std::size_t curve_;
  std::array<Field, 5> fields_;  ///< in the order of FormulaError::Field
  TypedFormula shown_;
  int gesture_ = 0;
  std::optional<FormulaCurve> before_;  ///< the curve when the gesture began
  bool isWrong_ = false;                ///< what stands in the fields is no curve
};

/// "a = 0.3, b = 2" as constants; nullopt if the text is not of this form.
std::optional<Expression::Constants> constantsFrom(const QString& text);
QString constantsText(const Expression::Constants& constants);

}  // namespace flatland::ui
