// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/profile_plot.h"

#include <qcustomplot.h>

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "ui/flat/wheel.h"
#include "ui/model/theme.h"
#include "ui/panels/wrap_row.h"
#include "ui/plot/profile_words.h"

namespace flatland::ui {

namespace {

constexpr double kZoomPerNotch = 1.2;
constexpr double kZoomPerKey = 1.4;
constexpr double kDegreesPerNotch = 120.0;  ///< QWheelEvent::angleDelta of one notch
constexpr double kStep = 0.002;             ///< of the arc length; Shift ten times
constexpr double kTextLines = 4.6;          ///< least height of a plot, in lines of text

bool isOwnKey(int key) {
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_0:
    case Qt::Key_Space:
      return true;
    default:
      return false;
  }
}

}  // namespace

ProfilePlot::ProfilePlot(Plots& plots, PlotKind kind, QWidget* parent)
    : QWidget(parent),
      plots_(plots),
      kind_(kind),
      plot_(new QCustomPlot(this)),
      title_(new QLabel(titleOf(kind), this)),
      values_(new QLabel(this)),
      drawing_(std::make_unique<ProfileDrawing>(*plot_, kind)) {
  title_->setToolTip(explanation(kind));
  values_->setToolTip(tr("The values at the probe"));
  values_->setTextFormat(Qt::RichText);
  values_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  values_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  plot_->setAccessibleName(titleOf(kind));
  plot_->setAccessibleDescription(explanation(kind));
  plot_->setToolTip(
      tr("Click or drag: probe. Wheel: zoom. Middle button or Space: move. "
         "Double-click: show all. Right button: copy, export."));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setProperty("drawsFocus", true);  // by the frame in paintEvent()
  plot_->setMinimumHeight(0);
  plot_->installEventFilter(this);
  setFocusProxy(plot_);
  title_->setContentsMargins(4, 0, 12, 0);
  values_->setContentsMargins(4, 0, 8, 0);
  // Where type is large the values go below the title; what is too long even so is cut.
  auto* header = new WrapRow(this);
  header->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  header->add(title_);
  header->add(values_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 1, 2, 2);
  layout->setSpacing(0);
  layout->addWidget(header);
  layout->addWidget(plot_, 1);
  connect(plot_, &QCustomPlot::afterReplot, this, [this] { ++replots_; });
  connect(&plots_, &Plots::changed, this, [this] { need(LookPart | LinesPart); });
  connect(&plots_, &Plots::rangeChanged, this, [this] { need(RangePart); });
  connect(&plots_, &Plots::probeMoved, this, [this] { need(ProbePart); });
}

ProfilePlot::~ProfilePlot() = default;

QWidget& ProfilePlot::surface() { return *plot_; }
double ProfilePlot::pixelOf(double x) const { return plot_->xAxis->coordToPixel(x); }
double ProfilePlot::abscissaAt(double pixel) const { return plot_->xAxis->pixelToCoord(pixel); }

QSize ProfilePlot::minimumSizeHint() const {
  const int line = fontMetrics().height();
  return {16 * line, static_cast<int>((hasNumbers_ ? kTextLines + 1.0 : kTextLines) * line)};
}

QSize ProfilePlot::sizeHint() const {
  return {400, static_cast<int>(1.5 * kTextLines * fontMetrics().height())};
}

void ProfilePlot::setNumbersBelow(bool on) {
  if (hasNumbers_ == on) return;
  hasNumbers_ = on;
  updateGeometry();
  need(LookPart | LinesPart);
}

void ProfilePlot::need(int parts) {
  needed_ |= parts;
  if (scheduled_ || !isVisible()) return;
  scheduled_ = true;
  QTimer::singleShot(0, this, &ProfilePlot::update_);
}

void ProfilePlot::update_() {
  scheduled_ = false;
  if (!isVisible()) return;
  const int parts = std::exchange(needed_, Nothing);
  if (parts == Nothing) return;
  if (parts & LookPart) {
    plot_->setFont(font());
    drawing_->setLook({.palette = themePalette(),
                       .scale = plots_.display().uiScale(),
                       .onPaper = false,
                       .xTicks = hasNumbers_});
  }
  if (parts & (LookPart | LinesPart)) {
    drawing_->show(plots_);
  } else {
    if (parts & RangePart) drawing_->showRange(plots_);
    drawing_->showProbe(plots_);
  }
  // Short, as the numbers stand beside it; the tip has it all.
  title_->setText(plots_.axisOf(kind_).scale == PlotAxis::Scale::Asinh
                      ? tr("%1, asinh").arg(titleOf(kind_))
                      : drawing_->heading());
  title_->setToolTip(drawing_->heading() + QStringLiteral("\n") + explanation(kind_));
  showValues();
  plot_->replot(QCustomPlot::rpQueuedRefresh);
}

void ProfilePlot::showValues() {
  QStringList parts;
  const std::vector<ProfileQuantity> quantities = plots_.quantitiesOf(kind_);
  const int digits = quantities.size() > 1 ? 3 : 4;  // several shall fit beside each other
  for (const ProfileQuantity quantity : quantities) {
    const auto value = plots_.probeValue(quantity);
    const QString number = value ? QString::number(*value, 'g', digits).replace('-', QChar(u'−'))
                                 : QStringLiteral("–");
    parts << QStringLiteral("<span style='color:%1'>%2&nbsp;%3</span>")
                 .arg(colourOf(quantity, themePalette()).name(), nameForPeople(quantity), number);
  }
  values_->setText(parts.join(QStringLiteral("&nbsp; ")));
}

bool ProfilePlot::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      dragging_ = false;
      panFrom_.reset();
      return true;
    case QEvent::MouseButtonDblClick:
      if (static_cast<const QMouseEvent&>(*event).button() == Qt::LeftButton) plots_.resetRange();
      return true;
    case QEvent::Wheel:
      return wheel(static_cast<const QWheelEvent&>(*event));
    case QEvent::NativeGesture: {
      const auto& pinch = static_cast<const QNativeGestureEvent&>(*event);
      if (pinch.gestureType() != Qt::ZoomNativeGesture) return false;
      plots_.zoomAt(abscissaAt(pinch.position().x()), std::max(1.0 + pinch.value(), 0.1));
      return true;
    }
    case QEvent::ContextMenu:
      emit menuWanted(static_cast<const QContextMenuEvent&>(*event).globalPos());
      return true;
    case QEvent::ShortcutOverride:
      // Keys of the plot before those of the menu.
      if (!isOwnKey(static_cast<const QKeyEvent&>(*event).key())) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event));
    case QEvent::KeyRelease:
      if (static_cast<const QKeyEvent&>(*event).key() == Qt::Key_Space) panKey_ = false;
      return false;
    case QEvent::FocusIn:
    case QEvent::FocusOut:
      panKey_ = false;
      update();  // the frame
      return false;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

bool ProfilePlot::press(const QMouseEvent& event) {
  plot_->setFocus(Qt::MouseFocusReason);
  const double x = abscissaAt(event.position().x());
  if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && panKey_)) {
    panFrom_ = x;
  } else if (event.button() == Qt::LeftButton) {
    dragging_ = true;
    plots_.setProbeAt(x);
  }
  return true;
}

bool ProfilePlot::move(const QMouseEvent& event) {
  const double x = abscissaAt(event.position().x());
  if (panFrom_) {
    plots_.panBy(*panFrom_ - x);
    drawing_->showRange(plots_);  // so that pixels mean the new range at the next move
  } else if (dragging_) {
    plots_.setProbeAt(x);
  }
  return true;
}

bool ProfilePlot::wheel(const QWheelEvent& event) {
  if (!wheelZoomsHere(event, plots_.display())) {
    const QPoint pixels = event.pixelDelta().isNull() ? event.angleDelta() / 8 : event.pixelDelta();
    if (std::abs(pixels.y()) > std::abs(pixels.x())) return false;  // for the panel to scroll
    plots_.panBy(abscissaAt(0.0) - abscissaAt(pixels.x()));
  } else {
    const double notches = event.angleDelta().y() / kDegreesPerNotch;
    plots_.zoomAt(abscissaAt(event.position().x()), std::pow(kZoomPerNotch, notches));
  }
  return true;
}

bool ProfilePlot::key(const QKeyEvent& event) {
  const Plots::Range shown = plots_.range();
  // Zooms go about the probe if it is in sight.
  const auto probe = plots_.probeX();
  const bool inSight = probe && *probe >= shown.low && *probe <= shown.high;
  const double middle = inSight ? *probe : 0.5 * (shown.low + shown.high);
  const double step = kStep * (event.modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0);
  switch (event.key()) {
    case Qt::Key_Left:
      plots_.moveProbe(-step);
      return true;
    case Qt::Key_Right:
      plots_.moveProbe(step);
      return true;
    case Qt::Key_Home:
      plots_.moveProbeToEnd(false);
      return true;
    case Qt::Key_End:
      plots_.moveProbeToEnd(true);
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      plots_.zoomAt(middle, kZoomPerKey);
      return true;
    case Qt::Key_Minus:
      plots_.zoomAt(middle, 1.0 / kZoomPerKey);
      return true;
    case Qt::Key_0:
      plots_.resetRange();
      return true;
    case Qt::Key_Space:
      panKey_ = true;
      return true;
    default:
      return false;
  }
}

void ProfilePlot::changeEvent(QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::PaletteChange || type == QEvent::FontChange || type == QEvent::StyleChange) {
    need(LookPart | LinesPart);
  }
  QWidget::changeEvent(event);
}

void ProfilePlot::paintEvent(QPaintEvent* event) {
  QWidget::paintEvent(event);
  if (!plot_->hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
}

void ProfilePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  need(RangePart);  // as many ticks as there is room for
}

void ProfilePlot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  need(needed_ | RangePart);
}

}  // namespace flatland::ui
