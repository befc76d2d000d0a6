// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/section_panel.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/commands/scene_commands.h"
#include "ui/commands/section_command.h"
#include "ui/model/bridge_words.h"
#include "ui/model/cutting_plane.h"
#include "ui/model/surface_look.h"
#include "ui/model/swept_surface.h"
#include "ui/panels/wrap_row.h"

namespace flatland::ui {

namespace {

constexpr double kPerMille = 1e-3;
constexpr int kStateLines = 2, kSentenceLines = 3;  ///< in a panel of the usual width
constexpr int kTableHeight = 120;

void setLines(QLabel& label, int lines) {
  label.setMinimumHeight(lines * label.fontMetrics().lineSpacing());
}

/// Of a pair: the crossing by its number in the pictures, the mark, their distance, the angle.
QStringList cellsOf(const SectionView& section, std::size_t index) {
  const SectionPair& pair = section.pairs[index];
  QString ridge = QStringLiteral("–"), mark = ridge, apart = ridge, angle = ridge;
  if (pair.ridge) ridge = SectionPanel::tr("× %1").arg(index + 1);
  if (pair.mark) {
    const Mark& its = section.marks.marks[*pair.mark].mark;
    mark = SectionPanel::tr("t = %1").arg(shortWords(its.t));
    if (section.section.scene.curves.size() > 1) {
      mark = SectionPanel::tr("%1: t = %2").arg(its.curve + 1).arg(shortWords(its.t));
    }
  }
  if (pair.distance) apart = shortWords(*pair.distance);
  if (pair.offPlaneDeg) angle = QLocale().toString(*pair.offPlaneDeg, 'f', 1) + "°";
  return {ridge, mark, apart, angle};
}

/// -1: none. That a row has the keys does not select it.
int selectedRow(const QTableWidget& table) {
  const QModelIndexList rows = table.selectionModel()->selectedRows();
  return rows.isEmpty() ? -1 : rows.front().row();
}

}  // namespace

SectionPanel::SectionPanel(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("section-panel");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makePresets());
  auto* form = new QFormLayout;
  form->setContentsMargins({});
  addFields(*form);
  layout->addLayout(form);
  open_ = new QPushButton(tr("&Open section as curve"), this);
  open_->setObjectName("section.open");
  connect(open_, &QPushButton::clicked, this, &SectionPanel::openAsCurve);
  layout->addWidget(open_);
  state_ = new QLabel(this);
  state_->setObjectName("section.state");
  state_->setAccessibleName(tr("The section"));
  sentence_ = new QLabel(this);
  sentence_->setObjectName("section.sentence");
  sentence_->setAccessibleName(tr("Why the pair differs"));
  weaker_ = new QLabel(this);
  weaker_->setObjectName("section.weaker");
  weaker_->setAccessibleName(tr("What the table leaves out"));
  for (QLabel* label : {state_, weaker_, sentence_}) {
    label->setToolTip(label->accessibleName());
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  }
  layout->addWidget(state_);
  table_ = new QTableWidget(0, 4, this);
  table_->setObjectName("section.pairs");
  table_->setAccessibleName(tr("Ridges of the surface beside those of the section"));
  table_->setToolTip(
      tr("Apparent ridges of the surface that go through the plane, each with the nearest apparent "
         "ridge of the section, and the angle between t_A and the plane. The row that is selected "
         "is ringed in both pictures"));
  table_->setHorizontalHeaderLabels(
      {tr("Surface"), tr("Section"), tr("Apart"), tr("t_A off plane")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(kTableHeight);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SectionPanel::showSentence);
  layout->addWidget(table_, 1);
  layout->addWidget(weaker_);
  layout->addWidget(sentence_);
  reserveLines();
  setFocusProxy(alongView_);
  connect(&models_.document, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface()) showPlane();
    if (change.touchesScene() || change.touchesSurface()) showSection();
  });
  connect(&models_.source, &SurfaceSource::changed, this, [this] {
    showPlane();
    showSection();
  });
  connect(&models_.pick, &SurfacePick::changed, this, &SectionPanel::showPlane);
  connect(&models_.bridges.section, &SectionSource::changed, this, &SectionPanel::showSection);
  connect(&models_.bridges.section, &SectionSource::failed, this, &SectionPanel::showSection);
  showPlane();
  showSection();
}

QWidget* SectionPanel::makePresets() {
  auto* row = new WrapRow(this);
  const auto add = [&](const char* id, const QString& text, const QString& tip, auto act) {
    auto* button = new QPushButton(text, row);
    button->setObjectName(id);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, act);
    row->add(button);
    return button;
  };
  alongView_ =
      add("section.along-view", tr("Through the &view"),
          tr("A plane that holds the line of sight, through the picked point or the middle "
             "of the picture"),
          &SectionPanel::cutAlongView);
  alongRidge_ = add("section.along-ridge", tr("Along &t_A"),
                    tr("A plane that holds the line of sight and t_A at the picked point (click on "
                       "the surface): there flatland's equation is the surface's"),
                    &SectionPanel::cutAlongRidge);
  remove_ =
      add("section.remove", tr("&Remove"), tr("Take the plane away"), &SectionPanel::removePlane);
  return row;
}

QDoubleSpinBox* SectionPanel::addField(QFormLayout& form, const char* id, const QString& name,
                                       const QString& tip) {
  auto* field = new QDoubleSpinBox(this);
  field->setObjectName(id);
  field->setToolTip(tip);
  field->setAccessibleName(QString(name).remove('&'));
  field->setKeyboardTracking(false);
  field->setLocale(QLocale::c());
  form.addRow(name, field);
  return field;
}

void SectionPanel::addFields(QFormLayout& form) {
  azimuth_ = addField(form, "section.azimuth", tr("A&zimuth"),
                      tr("Direction of the normal around the upright axis"));
  azimuth_->setRange(-360.0, 360.0);
  azimuth_->setDecimals(2);
  elevation_ =
      addField(form, "section.elevation", tr("E&levation"), tr("How far the normal points upward"));
  elevation_->setRange(-90.0, 90.0);
  elevation_->setDecimals(2);
  for (QDoubleSpinBox* field : {azimuth_, elevation_}) field->setSuffix(QStringLiteral("°"));
  height_ = addField(form, "section.height", tr("&Distance"),
                     tr("How far from the middle of the surface, along the normal; the surface's "
                        "longest side is 2"));
  height_->setRange(-2.0, 2.0);
  height_->setDecimals(4);
  height_->setSingleStep(0.02);
  for (QDoubleSpinBox* field : {azimuth_, elevation_, height_}) {
    connect(field, &QDoubleSpinBox::valueChanged, this, &SectionPanel::typed);
  }
  tolerance_ =
      addField(form, "section.tolerance", tr("To&lerance"),
               tr("How far the curve may be from the section, in thousandths of the "
                  "surface's longest side. Automatic: 1, and at least a tenth of an edge, so "
                  "that the curve does not follow the facets"));
  tolerance_->setRange(0.0, 100.0);
  tolerance_->setSpecialValueText(tr("automatic"));
  tolerance_->setDecimals(3);
  tolerance_->setSingleStep(0.5);
  tolerance_->setSuffix(QStringLiteral(" ‰"));
  tolerance_->setValue(models_.bridges.section.tolerance() / kPerMille);
  connect(tolerance_, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { models_.bridges.section.setTolerance(kPerMille * value); });
}

void SectionPanel::setPlane(const std::optional<SurfacePlane>& plane, const QString& text) {
  std::optional<SurfaceSetting> setting = models_.document.scene().surface;
  if (!setting) return;
  setting->plane = plane;
  models_.document.push(std::make_unique<SetSurface>(models_.document, setting, text));
}

void SectionPanel::cutAlongView() {
  const auto& setting = models_.document.scene().surface;
  if (!setting) return emit said(tr("There is no surface to cut."));
  const auto& hit = models_.pick.hit();
  setPlane(planeAlongView(setting->camera, hit ? hit->at : setting->camera.centre),
           tr("cut along the view"));
}

void SectionPanel::cutAlongRidge() {
  const auto& hit = models_.pick.hit();
  if (!hit) return emit said(tr("Click on the surface first: t_A is that of a point."));
  const auto plane = planeAlongRidgeAt(*models_.source.surface(), models_.foundView(), hit->at);
  if (!plane) return emit said(tr("There is no t_A at this point."));
  setPlane(plane, tr("cut along t_A"));
}

void SectionPanel::removePlane() { setPlane(std::nullopt, tr("remove plane")); }

void SectionPanel::openAsCurve() {
  const auto& section = models_.bridges.section.view();
  const QString why = whyNotOpened(section.get());
  if (!why.isEmpty()) return emit said(why);
  openSection(models_.document, *section);
  emit curvesOpened();
}

void SectionPanel::typed() {
  const auto& setting = models_.document.scene().surface;
  if (!setting || !setting->plane || !models_.source.surface()) return;
  SurfacePlane plane = *setting->plane;
  const double height = plane.point.dot(plane.normal);
  if (sender() == height_) {
    plane = moved(plane, height_->value() - height, models_.source.surface()->ballRadius);
  } else {
    // The other field shows its angle rounded; the azimuth of an upright normal is only there.
    NormalAngles angles = anglesOf(plane.normal);
    if (sender() == azimuth_ || !angles.azimuthDeg) angles.azimuthDeg = azimuth_->value();
    if (sender() == elevation_) angles.elevationDeg = elevation_->value();
    plane.normal = normalOf(angles);
  }
  setPlane(plane, tr("move plane"));
}

void SectionPanel::showPlane() {
  const auto& setting = models_.document.scene().surface;
  const bool there = setting && models_.source.surface();
  const bool cut = there && setting->plane;
  const QSignalBlocker azimuthSilent(azimuth_), elevationSilent(elevation_), heightSilent(height_);
  if (cut) {
    const NormalAngles angles = anglesOf(setting->plane->normal);
    if (angles.azimuthDeg) azimuth_->setValue(*angles.azimuthDeg);
    elevation_->setValue(angles.elevationDeg);
    height_->setValue(setting->plane->point.dot(setting->plane->normal));
  }
  for (QWidget* field : QList<QWidget*>{azimuth_, elevation_, height_, remove_}) {
    field->setEnabled(cut);
  }
  alongView_->setEnabled(there);
  alongRidge_->setEnabled(there && models_.pick.hit());
}

void SectionPanel::showSection() {
  const auto& section = models_.bridges.section.view();
  const QString why = whyNotOpened(section.get());
  open_->setEnabled(why.isEmpty());
  QString tip = tr("Put the section in the place of the scene's curves, seen as it is now");
  if (isSwept(models_.document.scene())) {
    tip += tr(". The swept surface goes with its curve; undo brings both back");
  }
  open_->setToolTip(why.isEmpty() ? tip : why);
  QStringList lines = section ? sectionWords(*section) : QStringList();
  if (section && !why.isEmpty() && !lines.contains(why)) lines << why;
  const auto& surface = models_.document.scene().surface;
  if (surface && !surface->plane) {
    lines << tr(
        "No plane yet. A button above puts one through the surface; its round handles turn "
        "it, the square moves it.");
  } else if (surface && !section && models_.source.surface()) {
    // The first cut of a scan takes a while, and one that failed leaves nothing.
    lines << (models_.bridges.section.isStale() ? tr("The surface is being cut.")
                                                : tr("The surface could not be cut here."));
  }
  state_->setText(lines.join('\n'));
  showTable();
}

bool SectionPanel::isWeak(const SectionPair& pair) const {
  const SurfaceSetting setting = models_.setting().surface;
  return !setting.unfiltered &&
         pair.strength < *familyOf(setting, LineFamily::ApparentRidges).threshold;
}

void SectionPanel::showTable() {
  const auto& section = models_.bridges.section.view();
  const int row = selectedRow(*table_);
  rows_.clear();
  int weaker = 0;
  for (std::size_t i = 0; section && i < section->pairs.size(); ++i) {
    isWeak(section->pairs[i]) ? void(++weaker) : rows_.push_back(i);
  }
  const int count = static_cast<int>(rows_.size());
  {
    const QSignalBlocker silent(table_);
    table_->setRowCount(count);
    for (int i = 0; i < count; ++i) {
      int column = 0;
      for (const QString& text : cellsOf(*section, rows_[static_cast<std::size_t>(i)])) {
        table_->setItem(i, column++, new QTableWidgetItem(text));
      }
    }
    row >= 0 && row < count ? table_->selectRow(row) : table_->clearSelection();
  }
  weaker_->setText(weaker > 0 ? tr("%n weaker than the view's threshold left out", nullptr, weaker)
                              : QString());
  showSentence();
}

void SectionPanel::showSentence() {
  const auto& section = models_.bridges.section.view();
  const int row = selectedRow(*table_);
  const bool there = section && row >= 0 && row < static_cast<int>(rows_.size());
  std::optional<std::size_t> pair;
  if (there) pair = rows_[static_cast<std::size_t>(row)];
  sentence_->setText(pair            ? pairWords(section->pairs[*pair])
                     : rows_.empty() ? QString()
                                     : tr("Select a row: here it says why the pair differs."));
  models_.bridges.section.choose(pair);
}

void SectionPanel::reserveLines() {
  setLines(*state_, kStateLines);
  setLines(*weaker_, 1);
  setLines(*sentence_, kSentenceLines);
}

void SectionPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) reserveLines();
  QWidget::changeEvent(event);
}

}  // namespace flatland::ui
