// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/derivation_panel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/lesson/lesson_words.h"
#include "ui/view3d/pane_marks.h"

namespace flatland::ui {

namespace {

constexpr int kNone = -1;       ///< no vertex is picked
constexpr int kTermDigits = 6;  ///< as many as the sum has

QString row(const QString& name, const QString& value) {
  return QStringLiteral("<tr><td>%1&nbsp;</td><td>=&nbsp;%2</td></tr>").arg(name, value);
}
QString list(const Eigen::VectorXd& v) {
  QStringList parts;
  for (const double x : v) parts << numberForPeople(x);
  return parts.join("&nbsp; ");
}
/// The ground of the equation that a lesson speaks of.
QString markedGround(const QPalette& palette) {
  constexpr double kShare = 0.25;  // little enough for the text to be read on it
  const QColor a = palette.color(QPalette::Base), b = palette.color(QPalette::Highlight);
  const auto mix = [](int x, int y) { return qRound((1.0 - kShare) * x + kShare * y); };
  return QColor(mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())).name();
}
QString matrix(const Eigen::Matrix2d& m) {
  return "(" + list(m.row(0).transpose()) + "; " + list(m.row(1).transpose()) + ")";
}

}  // namespace

QString titleForPeople(SurfaceStep step) {
  switch (step) {
    case SurfaceStep::View:
      return DerivationPanel::tr("The line of sight");
    case SurfaceStep::Eq4_1:
      return DerivationPanel::tr("Curvature");
    case SurfaceStep::Eq4_2:
      return DerivationPanel::tr("The derivative of curvature");
    case SurfaceStep::Foreshortening:
      return DerivationPanel::tr("Foreshortening");
    case SurfaceStep::Projection:
      return DerivationPanel::tr("The projection");
    case SurfaceStep::Inverse:
      return DerivationPanel::tr("Back from the screen");
    case SurfaceStep::Metric:
      return DerivationPanel::tr("Lengths on the screen");
    case SurfaceStep::Eq4_3:
      return DerivationPanel::tr("View-dependent curvature");
    case SurfaceStep::Lambda:
      return DerivationPanel::tr("Where the normal turns most");
    case SurfaceStep::Direction:
      return DerivationPanel::tr("The direction of it");
    case SurfaceStep::UnitDirection:
      return DerivationPanel::tr("A direction on the screen");
    case SurfaceStep::Turn:
      return DerivationPanel::tr("How the normal turns along it");
    case SurfaceStep::Eq4_4:
      return DerivationPanel::tr("What a unit vector cannot change");
    case SurfaceStep::Eq4_5:
      return DerivationPanel::tr("What is left");
    case SurfaceStep::Eq4_6:
      return DerivationPanel::tr("The derivative of K");
    case SurfaceStep::Footnote:
      return DerivationPanel::tr("The derivative of an inverse");
    case SurfaceStep::Eq4_7:
      return DerivationPanel::tr("The derivative of the projection");
    case SurfaceStep::Eq4_8:
      return DerivationPanel::tr("The derivative of λ");
    case SurfaceStep::Terms:
      return DerivationPanel::tr("Feature plus offset");
    case SurfaceStep::Perspective:
      break;
  }
  return DerivationPanel::tr("Seen from nearby");
}

DerivationPanel::DerivationPanel(SurfaceStudy& study, QWidget* parent)
    : QWidget(parent),
      study_(study),
      vertex_(new QSpinBox(this)),
      printed_(new QCheckBox(tr("As printed"), this)),
      text_(new QTextBrowser(this)) {
  setObjectName("surface-derivation-panel");
  vertex_->setObjectName("derivation.vertex");
  vertex_->setToolTip(tr("The vertex nearest to the picked point; type a number to pick another"));
  vertex_->setKeyboardTracking(false);
  vertex_->setSpecialValueText(tr("none"));
  vertex_->setRange(kNone, kNone);
  connect(vertex_, &QSpinBox::valueChanged, this, [this](int value) {
    if (value == kNone) return study_.pick().pick(std::nullopt);
    study_.pick().pickVertex(static_cast<std::uint32_t>(value));
  });
  auto* label = new QLabel(tr("Vertex"), this);
  label->setBuddy(vertex_);
  printed_->setObjectName("derivation.printed");
  printed_->setToolTip(tr("The equations that the thesis misprints, as it prints them"));
  printed_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the surface
  connect(printed_, &QCheckBox::toggled, this, &DerivationPanel::refresh);
  text_->setObjectName("derivation.text");
  text_->setAccessibleName(tr("Matrices and equations"));
  text_->setToolTip(
      tr("Both sides of each equation at the vertex, and their difference from the digits shown; "
         "lengths in units of the surface's size"));
  text_->setFrameShape(QFrame::NoFrame);
  // Who scrolls looks at something else.
  connect(text_->verticalScrollBar(), &QScrollBar::actionTriggered, this,
          [this] { wanted_.clear(); });
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(vertex_);
  row->addStretch(1);
  row->addWidget(printed_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addLayout(row);
  layout->addWidget(text_, 1);
  connect(&study_, &SurfaceStudy::changed, this, &DerivationPanel::refresh);
  refresh();
}

void DerivationPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void DerivationPanel::showEquation(const QString& id) {
  printed_->setChecked(false);
  wanted_ = marked_ = id;
  refresh();
}

void DerivationPanel::scrollToWanted() {
  if (wanted_.isEmpty() || !isVisible()) return;
  text_->scrollToAnchor(wanted_);
}

void DerivationPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  QMetaObject::invokeMethod(this, &DerivationPanel::scrollToWanted, Qt::QueuedConnection);
}

void DerivationPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();  // the mark has its colour
}

void DerivationPanel::refresh() {
  if (!isVisible() && !text_->document()->isEmpty()) return;
  SurfacePick& pick = study_.pick();
  const QSignalBlocker blocker(vertex_);
  vertex_->setEnabled(pick.surface() != nullptr);
  if (pick.surface()) {
    vertex_->setRange(kNone, static_cast<int>(pick.surface()->mesh->vertexCount()) - 1);
  }
  vertex_->setValue(pick.hit() ? static_cast<int>(pick.vertex()) : kNone);
  // What was read stays in sight while the camera moves.
  const int at = text_->verticalScrollBar()->value();
  if (!pick.hit()) {
    text_->setHtml(tr("Click a point of the surface, or press P over its picture."));
  } else if (!pick.surface()->fields) {
    text_->setHtml(tr("Curvature is still being estimated."));
  } else if (const auto& place = study_.place()) {
    const QString seenBy = seenByWords(study_.setting());
    const QString heading = seenBy.isEmpty() ? QString() : "<p><b>" + seenBy + "</b></p>";
    text_->setHtml(heading + matrices(*place) + steps(*place));
    // Not before the panel has its size, on which the place of the equation depends.
    QMetaObject::invokeMethod(this, &DerivationPanel::scrollToWanted, Qt::QueuedConnection);
  } else {
    text_->setHtml(tr("The normal is unknown here."));
  }
  text_->verticalScrollBar()->setValue(at);
}

QString DerivationPanel::matrices(const SurfacePlace& place) const {
  const SurfaceMatrices m = surfaceMatrices(place);
  const auto& c = place.point.C.coefficients;
  QString rows = row("K", matrix(m.K)) + row("C", list(Eigen::Vector4d(c[0], c[1], c[2], c[3]))) +
                 row("w<sub>T</sub>", list(m.wT)) + row("n·w", numberForPeople(m.nw)) +
                 row("P", matrix(m.P));
  if (m.seen) {
    rows += row("P⁻¹", matrix(m.inverseP)) + row("Q", matrix(m.Q)) + row("QᵀQ", matrix(m.QtQ)) +
            row("λ", tr("%1, the other %2")
                         .arg(numberForPeople(m.seen->lambda), numberForPeople(m.otherLambda))) +
            row("t<sub>A</sub>", list(m.tA)) + row("r", list(m.seen->r)) +
            row("½ D λ", tr("feature %1, offset %2, perspective %3")
                             .arg(numberForPeople(m.seen->feature), numberForPeople(m.seen->offset),
                                  numberForPeople(m.seen->perspective)));
  }
  const QString table = "<table cellspacing='0'>" + rows + "</table>";
  if (!m.seen || m.seen->sum() >= 0.0) return table;
  return table + "<p>" +
         tr("t<sub>A</sub> has no sign of its own: colours and the reading at the pointer take it "
            "towards larger λ, the other way round than here, and the three terms with it.") +
         "</p>";
}

/// What the sum of a step is made of.
QString DerivationPanel::terms(SurfaceStep step, const SurfacePlace& place) const {
  if (step != SurfaceStep::Terms && step != SurfaceStep::Perspective) return {};
  const SurfaceMatrices m = surfaceMatrices(place);
  if (!m.seen) return {};
  QString rows = row(tr("feature"), numberForPeople(m.seen->feature, kTermDigits)) +
                 row(tr("offset"), numberForPeople(m.seen->offset, kTermDigits));
  if (step == SurfaceStep::Perspective) {
    rows +=
        row(tr("perspective"), place.distance ? numberForPeople(m.seen->perspective, kTermDigits)
                                              : tr("0, the viewer is infinitely far away"));
  }
  return "<table cellspacing='0'>" + rows + "</table>";
}

QString DerivationPanel::steps(const SurfacePlace& place) const {
  QString html;
  for (int i = 0; i < kSurfaceStepCount; ++i) {
    const auto step = static_cast<SurfaceStep>(i);
    const DerivationStepText& text = textOf(step);
    const StepReading reading = readStep(step, place);
    const bool printed = printed_->isChecked() && text.isMisprinted();
    const bool known = reading.answer != StepAnswer::Evaluated || !printed || reading.printed;
    const QString id = QString::fromUtf8(text.id.data(), static_cast<qsizetype>(text.id.size()));
    const QString name = id.front().isDigit() ? "(" + id + ") " : QString();
    const QString ground =
        id == marked_ ? " style='background-color:" + markedGround(palette()) + "'" : QString();
    html +=
        QStringLiteral("<p%5><a name='%1'></a><b>%2%3</b>%4</p>")
            .arg(id, name, titleForPeople(step), printed ? tr(", as printed") : QString(), ground);
    html += known ? valuesForPeople(text, reading, printed)
                  : tr("There are no principal directions here.");
    html += terms(step, place);
  }
  return html;
}

}  // namespace flatland::ui
