// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/probe_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>
#include <cmath>

#include "flatland/study/probe_geometry.h"

namespace flatland::ui {

namespace {

constexpr int kDigits = 6;

QString text(double value) { return QString::number(value, 'g', kDigits); }
QString text(const Vec2& v) {
  // A component that is 0 but for rounding shall not take the room of its digits.
  const double size = v.cwiseAbs().maxCoeff();
  const auto part = [size](double x) {
    return QString::number(std::abs(x) < 1e-14 * size ? 0.0 : x, 'g', 5);
  };
  return part(v.x()) + QStringLiteral(", ") + part(v.y());
}

}  // namespace

ProbePanel::ProbePanel(const Document& document, Probe& probe, const Plots& plots, QWidget* parent)
    : QWidget(parent), document_(document), probe_(probe), plots_(plots) {
  auto* content = new QWidget;
  auto* grid = new QGridLayout(content);
  grid->setContentsMargins(8, 4, 8, 4);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(3);
  t_ = addField(*grid, 0, "probe.t", tr("t"),
                tr("Parameter on the curve: piece number plus place in the piece"));
  u_ =
      addField(*grid, 1, "probe.u", tr("u"), tr("Arc length from the start of the curve (length)"));
  addGeometry(*grid);
  addSeen(*grid);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  grid->setRowStretch(9, 1);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName("probe.scroll");
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(content);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addWidget(scroll);
  setFocusProxy(t_);
  connect(t_, &QLineEdit::editingFinished, this, &ProbePanel::typeT);
  connect(u_, &QLineEdit::editingFinished, this, &ProbePanel::typeU);
  connect(&probe_, &Probe::changed, this, &ProbePanel::showProbe);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.touchesScene()) showProbe();
  });
  showProbe();
}

ProbePanel::~ProbePanel() {
  // A field that goes while it has the focus tells that editing has finished.
  t_->disconnect(this);
  u_->disconnect(this);
}

QLineEdit* ProbePanel::addField(QGridLayout& grid, int row, const char* id, const QString& name,
                                const QString& meaning) {
  auto* label = new QLabel(name);
  auto* field = new QLineEdit;
  field->setObjectName(id);
  field->setToolTip(meaning + QStringLiteral("\n") + tr("Type a value and press Enter."));
  field->setAccessibleName(name);
  label->setBuddy(field);
  label->setToolTip(meaning);
  grid.addWidget(label, row, 0);
  grid.addWidget(field, row, 1);
  return field;
}

void ProbePanel::addRow(QGridLayout& grid, int row, int column, const char* id, const QString& name,
                        const QString& meaning, std::function<Said(const Probe::Reading&)> say) {
  auto* label = new QLabel(name);
  label->setToolTip(meaning);
  auto* value = new QLabel;
  value->setObjectName(id);
  value->setAccessibleName(name);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  value->setMinimumWidth(value->fontMetrics().horizontalAdvance("-0.12345, -0.12345"));
  grid.addWidget(label, row, 2 * column);
  grid.addWidget(value, row, 2 * column + 1);
  rows_.push_back({value, meaning, std::move(say)});
}

void ProbePanel::addGeometry(QGridLayout& grid) {
  using Reading = Probe::Reading;
  int row = 2;
  addRow(grid, row++, 0, "probe.point", tr("Point"), tr("Place in the plane (length)"),
         [](const Reading& r) {
           return Said{text(r.jet.p), {}};
         });
  addRow(grid, row++, 0, "probe.n", tr("n"), tr("Unit normal"), [](const Reading& r) {
    return Said{text(r.frame.normal), {}};
  });
  addRow(grid, row++, 0, "probe.tangent", tr("Tangent"), tr("Unit tangent, towards larger t"),
         [](const Reading& r) {
           return Said{text(r.frame.tangent), {}};
         });
  addRow(grid, row++, 0, "probe.k", tr("k"),
         tr("Curvature, dn/du = k t: positive where the curve bulges to the side of n (1/length)"),
         [](const Reading& r) {
           return Said{text(r.frame.k), {}};
         });
  addRow(grid, row++, 0, "probe.k-prime", tr("k'"), tr("Derivative of k by arc length (1/length²)"),
         [](const Reading& r) {
           return Said{text(r.frame.kPrime), {}};
         });
  addRow(grid, row++, 0, "probe.radius", tr("Radius"),
         tr("Radius of the osculating circle, 1/|k| (length)"), [this](const Reading& r) {
           constexpr double kStraight = 1e12;  // lengths of the curve
           const auto circle = osculatingCircle(r.jet, kStraight * plots_.profile().length);
           return circle ? Said{text(circle->radius), {}}
                         : Said{{}, tr("The curve is straight here: no finite radius.")};
         });
}

void ProbePanel::addSeen(QGridLayout& grid) {
  using Reading = Probe::Reading;
  const QString silhouette = tr("Infinite: the probe is at a silhouette.");
  int row = 0;
  addRow(grid, row++, 1, "probe.screen", tr("Screen"), tr("Coordinate on the screen (length)"),
         [this](const Reading& r) {
           const auto x = screenCoordinate(frameOf(document_.scene().view), r.jet.p);
           return x ? Said{text(*x), {}} : Said{{}, tr("At or behind the viewer: no image.")};
         });
  addRow(grid, row++, 1, "probe.nw", tr("n·w"), tr("Foreshortening; 0 at a silhouette"),
         [](const Reading& r) {
           return Said{text(r.terms.nw), {}};
         });
  addRow(grid, row++, 1, "probe.lambda", QStringLiteral("λ"),
         tr("View-dependent curvature squared, k²/(n·w)² (1/length²)"),
         [silhouette](const Reading& r) {
           const auto value = lambdaAt(r.terms);
           return value ? Said{text(*value), {}} : Said{{}, silhouette};
         });
  addRow(grid, row++, 1, "probe.screen-turn", tr("dn/di"),
         tr("Turn of the normal for a step on the screen, along the screen: k/|n·w| (1/length)"),
         [silhouette](const Reading& r) {
           const auto value = screenTurnAt(r.terms);
           return value ? Said{text(*value), {}} : Said{{}, silhouette};
         });
  addRow(grid, row++, 1, "probe.feature", tr("Feature"), tr("Feature term, (n·w) k k' (1/length³)"),
         [](const Reading& r) {
           return Said{text(r.terms.feature), {}};
         });
  addRow(grid, row++, 1, "probe.offset", tr("Offset"), tr("Offset term, −k³ (t·w) (1/length³)"),
         [](const Reading& r) {
           return Said{text(r.terms.offset), {}};
         });
  addRow(grid, row++, 1, "probe.perspective", tr("Perspective"),
         tr("Term added by the perspective view (1/length³)"), [this](const Reading& r) {
           return document_.scene().view.distance
                      ? Said{text(r.terms.perspective), {}}
                      : Said{{}, tr("0: the viewer is infinitely far away.")};
         });
  addRow(grid, row++, 1, "probe.sum", tr("Sum"),
         tr("Sum of the terms, (n·w)³/2 dλ/du; 0 at an apparent ridge (1/length³)"),
         [](const Reading& r) {
           return Said{text(r.terms.sum()), {}};
         });
  addRow(grid, row++, 1, "probe.ratio", tr("Ratio"),
         tr("Size of the offset term against the feature term, without unit"),
         [](const Reading& r) {
           const auto value = termRatioAt(r.terms, r.size);
           return value ? Said{text(*value), {}} : Said{{}, tr("The feature term is 0 here.")};
         });
}

void ProbePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showProbe();
}

void ProbePanel::showProbe() {
  if (!isVisible()) return;  // the arc length costs a profile
  const auto& place = probe_.place();
  t_->setEnabled(place.has_value());
  u_->setEnabled(place.has_value());
  t_->setText(place ? QString::number(place->t, 'g', 10) : QString());
  u_->setText(place ? QString::number(lengthAt(document_.scene().curves[place->curve].shape,
                                               plots_.profile(), place->t),
                                      'g', 10)
                    : QString());
  const auto reading = probe_.reading();
  const QString none = place ? tr("At a cusp the curve has no tangent.")
                             : tr("No probe: click on the curve, or press K.");
  for (const Row& row : rows_) {
    const Said said = reading ? row.say(*reading) : Said{{}, none};
    row.value->setText(said.value.isEmpty() ? QStringLiteral("–") : said.value);
    row.value->setToolTip(said.value.isEmpty() ? said.reason : row.meaning);
  }
}

void ProbePanel::typeT() {
  bool isNumber = false;
  const double t = QLocale::c().toDouble(t_->text(), &isNumber);
  // What was merely shown, rounded, must not move the probe.
  if (isNumber && probe_.place() && t_->isModified()) {
    probe_.setPlace(Probe::Place{probe_.place()->curve, t});
  }
  showProbe();
}

void ProbePanel::typeU() {
  bool isNumber = false;
  const double u = QLocale::c().toDouble(u_->text(), &isNumber);
  if (isNumber && probe_.place() && u_->isModified()) {
    const std::size_t curve = probe_.place()->curve;
    probe_.setPlace(Probe::Place{
        curve, parameterAtLength(document_.scene().curves[curve].shape, plots_.profile(), u)});
  }
  showProbe();
}

}  // namespace flatland::ui
