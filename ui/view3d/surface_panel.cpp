// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/commands/scene_commands.h"
#include "ui/model/core_words.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_overlay.h"

namespace flatland::ui {

namespace {

constexpr double kMostScale = 10.0;
constexpr int kCamerasHeight = 72;

}  // namespace

QString styleWords(SurfaceStyle style) {
  switch (style) {
    case SurfaceStyle::Paper:
      return SurfacePanel::tr("Paper, lines only");
    case SurfaceStyle::Flat:
      return SurfacePanel::tr("Flat triangles");
    case SurfaceStyle::Lambert:
      return SurfacePanel::tr("Matt (Lambert)");
    case SurfaceStyle::Toon:
      return SurfacePanel::tr("Toon");
    case SurfaceStyle::Gooch:
      return SurfacePanel::tr("Warm and cool (Gooch)");
    case SurfaceStyle::Normals:
      return SurfacePanel::tr("Normals");
    case SurfaceStyle::Colours:
      break;
  }
  return SurfacePanel::tr("Colour map");
}

SurfacePanel::SurfacePanel(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("surface-panel");
  report_ = new QLabel(this);
  report_->setObjectName("surface.report");
  report_->setAccessibleName(tr("What was found in the mesh"));
  report_->setToolTip(report_->accessibleName());
  report_->setWordWrap(true);
  report_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makeLook());
  layout->addWidget(makeCameras());
  layout->addWidget(report_);
  layout->addStretch(1);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showSetting();
  });
  connect(&models_.source, &SurfaceSource::changed, this, &SurfacePanel::showReport);
  showSetting();
  showReport();
}

QWidget* SurfacePanel::makeLook() {
  auto* look = new QWidget(this);
  auto* form = new QFormLayout(look);
  form->setContentsMargins({});
  style_ = new QComboBox(look);
  style_->setObjectName("surface.style");
  style_->setToolTip(tr("What is seen below the lines"));
  for (int i = 0; i < kSurfaceStyleCount; ++i) {
    style_->addItem(styleWords(static_cast<SurfaceStyle>(i)));
  }
  connect(style_, &QComboBox::activated, this, [this](int index) {
    edit(tr("change shading"), [index](SurfaceSetting& setting) {
      setting.style = nameOf(static_cast<SurfaceStyle>(index));
    });
  });
  form->addRow(tr("&Shading"), style_);
  quantity_ = new QComboBox(look);
  quantity_->setObjectName("surface.quantity");
  quantity_->setToolTip(
      tr("What the colour map shows; curvatures times the size of the surface. Choosing one makes "
         "the colour map the shading"));
  for (int i = 0; i < kSurfaceQuantityCount; ++i) {
    quantity_->addItem(quantityWords(static_cast<SurfaceQuantity>(i)));
  }
  // Who picks a quantity wants to see it.
  connect(quantity_, &QComboBox::activated, this, [this](int index) {
    edit(tr("change colour map"), [index](SurfaceSetting& setting) {
      setting.quantity = nameOf(static_cast<SurfaceQuantity>(index));
      setting.style = nameOf(SurfaceStyle::Colours);
    });
  });
  form->addRow(tr("&Colours of"), quantity_);
  scale_ = new QDoubleSpinBox(look);
  scale_->setObjectName("surface.scale");
  scale_->setToolTip(
      tr("How much larger than needed the neighbourhoods are that curvature is estimated from: "
         "larger is smoother"));
  scale_->setRange(1.0, kMostScale);
  scale_->setSingleStep(0.5);
  scale_->setDecimals(2);
  scale_->setKeyboardTracking(false);
  connect(scale_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit(tr("change smoothness"), [value](SurfaceSetting& setting) { setting.fitScale = value; });
  });
  form->addRow(tr("S&moothness"), scale_);
  return look;
}

QWidget* SurfacePanel::makeCameras() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins({});
  cameras_ = new QListWidget(box);
  cameras_->setObjectName("surface.cameras");
  cameras_->setAccessibleName(tr("Cameras kept"));
  cameras_->setToolTip(tr("Double-click or Return: look from there again"));
  cameras_->setMaximumHeight(kCamerasHeight);
  auto* keep = new QPushButton(tr("&Keep Camera"), box);
  keep->setObjectName("surface.camera.keep");
  keep->setToolTip(tr("Keep this view with the scene"));
  forget_ = new QPushButton(tr("&Forget"), box);
  forget_->setObjectName("surface.camera.forget");
  forget_->setToolTip(tr("Take the selected camera off the list"));
  connect(keep, &QPushButton::clicked, this, &SurfacePanel::keepCamera);
  connect(forget_, &QPushButton::clicked, this, &SurfacePanel::forgetCamera);
  connect(cameras_, &QListWidget::itemActivated, this, &SurfacePanel::useCamera);
  connect(cameras_, &QListWidget::itemDoubleClicked, this, &SurfacePanel::useCamera);
  connect(cameras_, &QListWidget::currentRowChanged, this,
          [this](int row) { forget_->setEnabled(row >= 0); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(keep);
  buttons->addWidget(forget_);
  layout->addWidget(cameras_);
  layout->addLayout(buttons);
  return box;
}

void SurfacePanel::showSetting() {
  const auto& scene = models_.document.scene().surface;
  setEnabled(scene.has_value());
  const SurfaceSetting setting = scene.value_or(SurfaceSetting{});
  const QSignalBlocker scale(scale_), cameras(cameras_);
  style_->setCurrentIndex(static_cast<int>(styleOf(setting)));
  quantity_->setCurrentIndex(static_cast<int>(quantityOf(setting)));
  scale_->setValue(setting.fitScale);
  cameras_->clear();
  for (const SavedCamera& saved : setting.savedCameras) {
    cameras_->addItem(QString::fromStdString(saved.name));
  }
  forget_->setEnabled(false);
}

void SurfacePanel::showReport() {
  const auto& surface = models_.source.surface();
  if (!surface) return report_->clear();
  QStringList lines{
      tr("%Ln vertices", nullptr, static_cast<int>(surface->mesh->vertexCount())) + ", " +
          tr("%Ln triangles", nullptr, static_cast<int>(surface->mesh->triangleCount())),
      tr("Read in %1 ms").arg(qRound(surface->loadMs))};
  if (surface->fields) lines << tr("Curvature in %1 ms").arg(qRound(surface->fieldMs));
  for (const std::string& sentence : surface->report.sentences()) {
    lines << coreWords(sentence);
  }
  report_->setText(lines.join('\n'));
}

void SurfacePanel::edit(const QString& text, const std::function<void(SurfaceSetting&)>& change) {
  std::optional<SurfaceSetting> setting = models_.document.scene().surface;
  if (!setting) return;
  change(*setting);
  models_.document.push(std::make_unique<SetSurface>(models_.document, std::move(setting), text));
}

void SurfacePanel::keepCamera() {
  edit(tr("keep camera"), [pane = models_.views.active()](SurfaceSetting& setting) {
    // The smallest number that is free.
    for (int i = 1;; ++i) {
      const std::string name = tr("Camera %1").arg(i).toStdString();
      const auto taken = [&name](const SavedCamera& saved) { return saved.name == name; };
      if (std::any_of(setting.savedCameras.begin(), setting.savedCameras.end(), taken)) continue;
      setting.savedCameras.push_back({name, paneCamera(setting, pane)});
      return;
    }
  });
}

void SurfacePanel::useCamera() {
  const auto& setting = models_.document.scene().surface;
  const int row = cameras_->currentRow();
  if (!setting || row < 0) return;
  models_.document.setCamera(setting->savedCameras[static_cast<std::size_t>(row)].camera,
                             models_.views.active());
}

void SurfacePanel::forgetCamera() {
  const int row = cameras_->currentRow();
  if (row < 0) return;
  edit(tr("forget camera"), [row](SurfaceSetting& setting) {
    setting.savedCameras.erase(setting.savedCameras.begin() + row);
  });
}

}  // namespace flatland::ui
