// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/bridge_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/commands/scene_commands.h"
#include "ui/commands/sweep_command.h"
#include "ui/model/bridge_words.h"
#include "ui/model/core_words.h"
#include "ui/plot/bridge_study.h"

namespace flatland::ui {

namespace {

enum KindIndex { kNone, kExtrusion, kRevolution };
constexpr int kDecimals = 4;
// The field rounds to its decimals: the least height is the least of these that is not 0.
constexpr double kMostAmount = 1e6, kLeastHeight = 1e-4;

}  // namespace

BridgePanel::BridgePanel(const CanvasModels& models, Bridges& bridges, QWidget* parent)
    : QWidget(parent), models_(models), bridges_(bridges) {
  setObjectName("bridge-panel");
  auto* form = new QFormLayout;
  form->setContentsMargins({});
  addSweep(*form);
  addSwitches(*form);
  why_ = new QLabel(this);
  why_->setObjectName("bridge.why");
  why_->setAccessibleName(tr("Why the views are not linked"));
  why_->setToolTip(why_->accessibleName());
  agreement_ = new QLabel(this);
  agreement_->setObjectName("bridge.agreement");
  agreement_->setAccessibleName(tr("How prediction and lines agree"));
  agreement_->setToolTip(
      tr("Median distance of the lines found from those that flatland predicts, in edges of the "
         "mesh, and how much of the predicted lines was found"));
  for (QLabel* label : {why_, agreement_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  }
  study_ = new BridgeStudy(models.document, bridges.source, models.display, this);
  connect(study_, &BridgeStudy::said, this, &BridgePanel::said);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(why_);
  layout->addWidget(agreement_);
  layout->addWidget(study_);
  layout->addStretch(1);
  setFocusProxy(kind_);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    const bool curves = change.touchesScene() && change.what != Change::What::View;
    if (change.touchesSurface() || curves) showSetting();
  });
  connect(&bridges_.link, &ViewLink::changed, this, &BridgePanel::showSetting);
  connect(&bridges_.source, &BridgeSource::changed, this, &BridgePanel::showAgreement);
  showSetting();
  showAgreement();
}

void BridgePanel::addSweep(QFormLayout& form) {
  kind_ = new QComboBox(this);
  kind_->setObjectName("bridge.kind");
  kind_->addItems({tr("Not swept"), tr("Extrusion"), tr("Revolution")});
  kind_->setToolTip(
      tr("How the curve becomes a surface: moved across its plane, or turned about "
         "an axis in it"));
  connect(kind_, &QComboBox::activated, this, &BridgePanel::chooseKind);
  form.addRow(tr("S&urface"), kind_);
  curve_ = new QComboBox(this);
  curve_->setObjectName("bridge.curve");
  curve_->setToolTip(tr("Which curve of the scene is swept"));
  connect(curve_, &QComboBox::activated, this, [this](int index) {
    edit(tr("sweep another curve"),
         [index](SweptSetting& swept) { swept.curve = static_cast<std::size_t>(index); });
  });
  form.addRow(tr("&Curve"), curve_);
  amount_ = new QDoubleSpinBox(this);
  amount_->setObjectName("bridge.amount");
  amount_->setDecimals(kDecimals);
  amount_->setKeyboardTracking(false);
  amount_->setSingleStep(0.1);
  amount_->setLocale(QLocale::c());
  connect(amount_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit(tr("change sweep"), [value](SweptSetting& swept) { swept.amount = value; });
  });
  amountName_ = new QLabel(this);
  amountName_->setBuddy(amount_);
  form.addRow(amountName_, amount_);
  cells_ = new QSpinBox(this);
  cells_->setObjectName("bridge.cells");
  cells_->setRange(kFewestSweptCells, kMostSweptCells);
  cells_->setSingleStep(16);
  cells_->setKeyboardTracking(false);
  cells_->setToolTip(
      tr("Cells of the mesh along the curve. While a curve is dragged there are as "
         "many as keep up with the hand"));
  connect(cells_, &QSpinBox::valueChanged, this, [this](int value) {
    edit(tr("change resolution"), [value](SweptSetting& swept) { swept.cells = value; });
  });
  form.addRow(tr("C&ells"), cells_);
}

void BridgePanel::addSwitches(QFormLayout& form) {
  link_ = new QCheckBox(tr("&Link views"), this);
  link_->setObjectName("bridge.link");
  link_->setToolTip(tr("Who turns the surface turns the flat view, and the other way"));
  connect(link_, &QCheckBox::toggled, this, [this](bool on) { bridges_.link.setOn(on); });
  predicted_ = new QCheckBox(tr("&Predicted lines"), this);
  predicted_->setObjectName("bridge.predicted");
  predicted_->setToolTip(
      tr("Draw where flatland says that the lines are, dashed, with ticks at the "
         "edge of the picture; pale where they cannot be expected"));
  connect(predicted_, &QCheckBox::toggled, this, [this](bool on) { bridges_.source.setShown(on); });
  form.addRow(link_, predicted_);
}

void BridgePanel::edit(const QString& text, const std::function<void(SweptSetting&)>& change) {
  std::optional<SurfaceSetting> setting = models_.document.scene().surface;
  if (!setting || !setting->swept) return;
  change(*setting->swept);
  // Files with such a height are refused (flatland/io/surface_json.cpp).
  const bool revolution = kindOf(*setting->swept) == SweptSurface::Kind::Revolution;
  if (!revolution && !(setting->swept->amount > 0.0)) return showSetting();
  models_.document.push(std::make_unique<SetSurface>(models_.document, setting, text));
}

void BridgePanel::chooseKind(int index) {
  const Scene& scene = models_.document.scene();
  if (index == kNone) {
    if (isSwept(scene)) {
      models_.document.push(
          std::make_unique<SetSurface>(models_.document, std::nullopt, tr("close surface")));
    }
    return;
  }
  const auto kind =
      index == kRevolution ? SweptSurface::Kind::Revolution : SweptSurface::Kind::Extrusion;
  std::optional<std::size_t> curve = models_.selection.currentCurve();
  if (isSwept(scene)) {
    if (kindOf(*scene.surface->swept) == kind) return;
    curve = scene.surface->swept->curve;
  }
  if (!curve || *curve >= scene.curves.size()) {
    showSetting();
    return emit said(tr("There is no curve to make a surface of."));
  }
  sweepCurve(models_.document, *curve, kind);
}

void BridgePanel::showSetting() {
  const Scene& scene = models_.document.scene();
  const bool swept = isSwept(scene);
  const SweptSetting setting = swept ? *scene.surface->swept : SweptSetting{};
  const bool revolution = kindOf(setting) == SweptSurface::Kind::Revolution;
  const QSignalBlocker kindSilent(kind_), curveSilent(curve_), amountSilent(amount_),
      cellsSilent(cells_), linkSilent(link_), predictedSilent(predicted_);
  kind_->setCurrentIndex(!swept ? kNone : revolution ? kRevolution : kExtrusion);
  curve_->clear();
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    curve_->addItem(tr("Curve %1").arg(i + 1));
  }
  const bool there = setting.curve < scene.curves.size();
  curve_->setCurrentIndex(swept && there ? static_cast<int>(setting.curve) : -1);
  amountName_->setText(revolution ? tr("&Axis at x") : tr("&Height"));
  amount_->setToolTip(revolution ? tr("Where the upright axis of the revolution is")
                                 : tr("How far the curve is moved across its plane"));
  amount_->setRange(revolution ? -kMostAmount : kLeastHeight, kMostAmount);
  amount_->setValue(setting.amount);
  cells_->setValue(setting.cells);
  link_->setChecked(bridges_.link.isOn());
  predicted_->setChecked(bridges_.source.isShown());
  for (QWidget* field : QList<QWidget*>{curve_, amount_, cells_, predicted_}) {
    field->setEnabled(swept);
  }
  link_->setEnabled(bridges_.link.canLink());
  QString why;
  if (swept && !there) why = tr("The curve that the surface was swept from is gone.");
  if (!bridges_.link.whyNot().empty()) why = asSentence(coreWords(bridges_.link.whyNot()));
  why_->setText(why);
  why_->setVisible(!why.isEmpty());
}

void BridgePanel::showAgreement() {
  const auto& view = bridges_.source.view();
  agreement_->setText(view ? agreementWords(*view).join('\n') : QString());
  agreement_->setVisible(!agreement_->text().isEmpty());
}

}  // namespace flatland::ui
