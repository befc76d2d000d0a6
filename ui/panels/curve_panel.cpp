// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/curve_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "flatland/io/number_text.h"
#include "ui/commands/curve_commands.h"
#include "ui/model/core_words.h"
#include "ui/panels/family_editor.h"
#include "ui/panels/formula_editor.h"

namespace flatland::ui {

namespace {

/// Of a conversion, relative to the size of the curve.
constexpr double kConversion = 1e-6;

/// Changes when the editor must be another one.
QString sortOf(const Curve& curve, std::size_t index) {
  QString sort = QStringLiteral("%1 %2").arg(index).arg(curve.index());
  if (const auto* formula = std::get_if<FormulaCurve>(&curve)) {
    sort += formula->family() ? QString::fromStdString(familyOf(*formula->family()).name)
                              : QStringLiteral("typed");
  }
  if (const auto* rational = std::get_if<RationalBezier>(&curve)) {
    sort += QStringLiteral(" %1").arg(rational->weights().size());
  }
  return sort;
}

}  // namespace

CurvePanel::CurvePanel(const CanvasModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  heading_ = new QLabel(this);
  heading_->setObjectName("curve.kind");
  heading_->setWordWrap(true);
  convert_ = new QPushButton(tr("&Convert to Bezier Chain"), this);
  convert_->setObjectName("curve.convert");
  connect(convert_, &QPushButton::clicked, this, &CurvePanel::convert);
  auto* column = new QVBoxLayout(this);
  column->addWidget(heading_);
  room_ = new QVBoxLayout;
  column->addLayout(room_);
  column->addWidget(convert_, 0, Qt::AlignLeft);
  column->addStretch(1);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesScene() && change.what != Change::What::View) refresh();
  });
  connect(&models_.selection, &Selection::changed, this, &CurvePanel::refresh);
  refresh();
}

QString CurvePanel::description(const Curve& curve) const {
  QString text = coreWords(kindName(curve));
  if (degreeOf(curve) > 0) text += tr(", degree %1").arg(degreeOf(curve));
  text += isClosed(curve) ? tr(", closed") : tr(", open");
  if (!controlPoints(curve).empty()) text += tr(", points: %1").arg(controlPoints(curve).size());
  return text + tr(", pieces: %1").arg(pieceCount(curve));
}

void CurvePanel::refresh() {
  const auto current = models_.selection.currentCurve();
  const auto& curves = models_.document.scene().curves;
  if (!current || *current >= curves.size()) {
    heading_->setText(tr("No curve. The menu Curve > New adds one."));
    convert_->hide();
    build(std::nullopt);
    return;
  }
  const Curve& curve = curves[*current].shape;
  heading_->setText(tr("Curve %1: %2").arg(*current).arg(description(curve)));
  convert_->setVisible(!std::holds_alternative<BezierChain>(curve));
  convert_->setToolTip(bezierForm(curve)
                           ? tr("The same curve as Bezier pieces with points to drag: exact")
                           : tr("Cubic Bezier pieces with points to drag, within a millionth of "
                                "the size of the curve"));
  build(current);
}

void CurvePanel::build(std::optional<std::size_t> index) {
  const auto& curves = models_.document.scene().curves;
  const QString sort = index ? sortOf(curves[*index].shape, *index) : QString();
  if (sort == built_) {
    if (show_) show_();
    return;
  }
  built_ = sort;
  show_ = {};
  if (editor_) {
    // It may be an event of the editor's own that led here.
    editor_->hide();
    editor_->disconnect();
    editor_->deleteLater();
    editor_ = nullptr;
  }
  if (!index) return;
  const Curve& curve = curves[*index].shape;
  if (const auto* formula = std::get_if<FormulaCurve>(&curve)) {
    if (formula->family()) {
      auto* editor = new FamilyEditor(models_.document, *index, this);
      connect(editor, &FamilyEditor::refused, this, &CurvePanel::said);
      show_ = [editor] { editor->refresh(); };
      editor_ = editor;
    } else {
      auto* editor = new FormulaEditor(models_.document, *index, this);
      show_ = [editor] { editor->refresh(); };
      editor_ = editor;
    }
  } else if (std::holds_alternative<RationalBezier>(curve)) {
    editor_ = weightsEditor(*index);
  }
  if (editor_) room_->addWidget(editor_);
}

QWidget* CurvePanel::weightsEditor(std::size_t curve) {
  const auto shape = [this, curve]() -> const RationalBezier& {
    return std::get<RationalBezier>(models_.document.scene().curves[curve].shape);
  };
  auto* table = new QTableWidget(static_cast<int>(shape().weights().size()), 1, this);
  table->setObjectName("curve.weights");
  table->setAccessibleName(tr("Weights"));
  table->setToolTip(tr("How strongly each point pulls the curve: a number above 0"));
  table->setHorizontalHeaderLabels({tr("Weight")});
  table->horizontalHeader()->setStretchLastSection(true);
  show_ = [table, shape] {
    const QSignalBlocker silent(table);
    for (int i = 0; i < table->rowCount(); ++i) {
      table->setVerticalHeaderItem(i, new QTableWidgetItem(QString::number(i)));
      const double weight = shape().weights()[static_cast<std::size_t>(i)];
      table->setItem(i, 0, new QTableWidgetItem(QString::fromStdString(numberText(weight))));
    }
  };
  show_();
  connect(table, &QTableWidget::itemChanged, this, [this, curve, shape](QTableWidgetItem* item) {
    const RationalBezier& before = shape();
    std::vector<double> weights = before.weights();
    bool isNumber = false;
    const double typed = item->text().trimmed().replace(',', '.').toDouble(&isNumber);
    const auto index = static_cast<std::size_t>(item->row());
    if (isNumber) weights[index] = typed;
    const auto why = RationalBezier::whyInvalid(before.degree(), before.closed(),
                                                before.points().size(), weights);
    if (!isNumber || why) {
      emit said(isNumber
                    ? coreWords(*why)
                    : tr("\u201c%1\u201d is not a number; the weight stays.").arg(item->text()));
    } else {
      models_.document.push(std::make_unique<ReplaceCurve>(
          models_.document, curve,
          RationalBezier(before.degree(), before.closed(), before.points(), std::move(weights)),
          tr("change weight")));
    }
    // The text as the curve has it, once the editor is done with it.
    QMetaObject::invokeMethod(this, &CurvePanel::refresh, Qt::QueuedConnection);
  });
  return table;
}

void CurvePanel::convert() {
  const auto current = models_.selection.currentCurve();
  if (!current) return;
  const Curve& curve = models_.document.scene().curves[*current].shape;
  const double tolerance = kConversion * boundsOf(curve).diagonal();
  if (!(tolerance > 0.0)) {
    emit said(tr("The curve is a single point and stays as it is."));
    return;
  }
  const bool exact = bezierForm(curve) != nullptr;
  BezierChain chain = asBezierChain(curve, tolerance);
  const int pieces = chain.pieceCount();
  models_.document.push(std::make_unique<ReplaceCurve>(models_.document, *current, std::move(chain),
                                                       tr("convert curve")));
  emit said(
      exact ? tr("Converted exactly; Bezier pieces: %1.").arg(pieces)
            : tr("Converted within %1; cubic pieces: %2.").arg(tolerance, 0, 'g', 2).arg(pieces));
}

}  // namespace flatland::ui
