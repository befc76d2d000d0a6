// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/profile_drawing.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/plot/profile_words.h"

namespace flatland::ui {

namespace {

constexpr double kLinePx = 1.6;
constexpr double kProbeDotPx = 7.0;
constexpr double kSymbolShare = 0.8;   // of their size on the canvas: plots are small
constexpr double kTickSpacing = 1.15;  // of the text height, between labels

/// How a quantity's line is told from others on the same plot without its colour.
Qt::PenStyle styleOf(ProfileQuantity quantity) {
  if (quantity == ProfileQuantity::Offset) return Qt::DashLine;
  return quantity == ProfileQuantity::Perspective ? Qt::DotLine : Qt::SolidLine;
}

/// A power of ten as a person writes it.
QString powerText(int exponent) {
  if (exponent >= -3 && exponent <= 3) {
    return QString::number(std::pow(10.0, exponent), 'f', std::max(0, -exponent));
  }
  static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString text = QStringLiteral("10");
  for (const QChar c : QString::number(exponent)) {
    text += c == '-' ? QChar(u'⁻') : kDigits[c.digitValue()];
  }
  return text;
}

/// The label for a value of a plot: a power of ten, negative or not.
QString signedPower(double sign, int exponent) {
  return (sign < 0.0 ? QStringLiteral("−") : QString()) + powerText(exponent);
}

QPen markPen(MarkKind kind, bool visible, const ProfileDrawing::Look& look) {
  const MarkStyle& style = styleOf(kind, look.palette);
  const Rgb background = sceneColours(look.palette).background;
  QPen pen(toQColor(visible ? style.colour : paler(style.colour, background)));
  const double width = style.lineWidth * look.scale;
  pen.setWidthF(width);
  pen.setCapStyle(Qt::FlatCap);
  if (!style.dash.empty()) {
    QList<qreal> pattern;
    for (const double length : style.dash) pattern << length / style.lineWidth;
    pen.setDashPattern(pattern);
  }
  return pen;
}

QCPScatterStyle symbolStyle(MarkKind kind, bool visible, const ProfileDrawing::Look& look) {
  constexpr double kUnscaled = 6.0;  // QCustomPlot draws a path of this size as it is
  const PathShape shape = markSymbol(kind, Vec2::Zero(), kSymbolShare * kSymbolSizePx * look.scale,
                                     0.0, look.palette, !visible);
  QPen pen(Qt::NoPen);
  if (shape.stroke) pen = QPen(toQColor(shape.stroke->colour), shape.stroke->width * look.scale);
  return {toPainterPath(shape.path), pen,
          shape.fill ? QBrush(toQColor(*shape.fill)) : QBrush(Qt::NoBrush), kUnscaled};
}

/// As on the canvas: a hollow bar, dashed.
QCPScatterStyle printedRootStyle(const ProfileDrawing::Look& look) {
  constexpr double kUnscaled = 6.0;  // as above
  const PrintedRootStyle style;
  const double width = style.barWidth * look.scale,
               length = kSymbolShare * style.barLength * look.scale;
  QPainterPath bar;
  bar.addRect(-width / 2.0, -length / 2.0, width, length);
  const QColor outline = toQColor(styleOf(MarkKind::ApparentRidge, look.palette).letterColour);
  return {bar, QPen(outline, style.outline * look.scale, Qt::DashLine),
          QBrush(toQColor(sceneColours(look.palette).background)), kUnscaled};
}

/// A line of which the height does not matter: from the foot of the plot to its top.
void standAt(QCPItemStraightLine& line, double x) {
  line.point1->setCoords(x, 0.0);
  line.point2->setCoords(x, 1.0);
}

}  // namespace

QColor colourOf(ProfileQuantity quantity, Palette palette) {
  const PlotColours colours = plotColours(palette);
  switch (quantity) {
    case ProfileQuantity::Feature:
      return colours.feature;
    case ProfileQuantity::Offset:
      return colours.offset;
    case ProfileQuantity::Perspective:
      return colours.probe;
    default:
      return colours.line;
  }
}

ProfileDrawing::ProfileDrawing(QCustomPlot& plot, PlotKind kind)
    : plot_(plot),
      kind_(kind),
      printedDots_(nullptr),
      probeLine_(new QCPItemStraightLine(&plot)),
      probeDots_(nullptr) {
  plot_.setAntialiasedElements(QCP::aeAll);
  plot_.setNoAntialiasingOnDrag(false);
  plot_.addLayer("marks", plot_.layer("grid"), QCustomPlot::limAbove);
  plot_.addLayer("symbols", plot_.layer("main"), QCustomPlot::limAbove);
  plot_.addLayer("probe", plot_.layer("symbols"), QCustomPlot::limAbove);
  if (kind_ == PlotKind::Ratio) {
    unity_ = new QCPItemStraightLine(&plot_);
    unity_->setLayer("marks");
    unity_->point1->setType(QCPItemPosition::ptPlotCoords);
    unity_->point1->setCoords(0.0, 1.0);
    unity_->point2->setCoords(1.0, 1.0);
  }
  printedDots_ = plot_.addGraph();
  printedDots_->setLayer("symbols");
  printedDots_->setLineStyle(QCPGraph::lsNone);
  printedDots_->removeFromLegend();
  probeLine_->setLayer("probe");
  probeLine_->setVisible(false);
  probeDots_ = plot_.addGraph();
  probeDots_->setLayer("probe");
  probeDots_->setLineStyle(QCPGraph::lsNone);
  probeDots_->removeFromLegend();
  const bool log = kind_ == PlotKind::Lambda || kind_ == PlotKind::Ratio;
  plot_.yAxis->setScaleType(log ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
  plot_.yAxis->setNumberPrecision(4);
  plot_.xAxis->setNumberPrecision(6);
}

void ProfileDrawing::setLook(const Look& look) {
  look_ = look;
  stylePlot(plot_, look_.palette);
  const PlotColours colours = plotColours(look_.palette);
  if (unity_) unity_->setPen(QPen(colours.text, 1.2 * look_.scale, Qt::DashDotLine));
  probeLine_->setPen(QPen(colours.probe, 1.6 * look_.scale));
  probeDots_->setScatterStyle({QCPScatterStyle::ssCircle, QPen(colours.background, 1.0),
                               QBrush(colours.probe), kProbeDotPx * look_.scale});
  for (auto& [key, graph] : symbols_) {
    graph->setScatterStyle(symbolStyle(key.first, key.second, look_));
  }
  printedDots_->setScatterStyle(printedRootStyle(look_));
  setMargins();
}

void ProfileDrawing::setMargins() {
  QCPAxisRect& rect = *plot_.axisRect();
  if (look_.onPaper) {
    rect.setAutoMargins(QCP::msAll);
    return;
  }
  // The same on every plot, so that what is above each other belongs together.
  const QFontMetrics metrics(plot_.font());
  rect.setAutoMargins(QCP::msNone);
  plot_.xAxis->setTickLabels(look_.xTicks);
  const int below = look_.xTicks ? metrics.height() + 8 : 7;
  rect.setMargins(QMargins(metrics.horizontalAdvance("−0.0000") + 12, 3, 10, below));
}

double ProfileDrawing::onAxis(double value) const {
  return axis_.scale == PlotAxis::Scale::Asinh ? std::asinh(value / axis_.linear) : value;
}

void ProfileDrawing::show(const Plots& plots) {
  axis_ = plots.axisOf(kind_);
  const QString against = plots.abscissa() == Abscissa::ArcLength
                              ? ProfileWords::tr("arc length u")
                              : ProfileWords::tr("screen coordinate");
  plot_.xAxis->setLabel(look_.onPaper ? against : QString());
  const bool several = plots.quantitiesOf(kind_).size() > 1;
  plot_.legend->setVisible(look_.onPaper && several);
  plot_.axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
  showLines(plots);
  showMarks(plots);
  showRange(plots);
  showProbe(plots);
}

QCPCurve& ProfileDrawing::curveOf(ProfileQuantity quantity) {
  QCPCurve*& curve = curves_[quantity];
  if (!curve) curve = new QCPCurve(plot_.xAxis, plot_.yAxis);
  curve->setName(nameForPeople(quantity));
  const double width = quantity == ProfileQuantity::Sum ? 0.75 * kLinePx : kLinePx;
  curve->setPen(QPen(colourOf(quantity, look_.palette), width * look_.scale, styleOf(quantity),
                     Qt::FlatCap, Qt::RoundJoin));
  return *curve;
}

void ProfileDrawing::showLines(const Plots& plots) {
  const std::vector<ProfileQuantity> shown = plots.quantitiesOf(kind_);
  for (auto& [quantity, curve] : curves_) {
    if (std::find(shown.begin(), shown.end(), quantity) == shown.end()) curve->data()->clear();
  }
  const bool positive = axis_.scale == PlotAxis::Scale::Log;
  for (const ProfileQuantity quantity : shown) {
    QVector<QCPCurveData> data;
    double index = 0.0;
    for (const auto& line :
         flatland::linesOf(plots.profile(), quantity, plots.abscissa(), positive)) {
      for (const Vec2& p : line) data.append({index++, p.x(), onAxis(p.y())});
      data.append({index++, qQNaN(), qQNaN()});  // the pen is lifted
    }
    curveOf(quantity).data()->set(data, true);
  }
}

void ProfileDrawing::showMarks(const Plots& plots) {
  const std::vector<PlotMark> marks = plots.marks();
  resizeLines(markLines_, marks.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    standAt(*markLines_[i], marks[i].x);
    markLines_[i]->setPen(markPen(marks[i].kind, marks[i].visible, look_));
  }
}

void ProfileDrawing::resizeLines(std::vector<QCPItemStraightLine*>& lines, std::size_t count) {
  while (lines.size() > count) {
    plot_.removeItem(lines.back());
    lines.pop_back();
  }
  while (lines.size() < count) {
    auto* line = new QCPItemStraightLine(&plot_);
    line->setLayer("marks");
    for (QCPItemPosition* point : {line->point1, line->point2}) {
      point->setTypeX(QCPItemPosition::ptPlotCoords);
      point->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    lines.push_back(line);
  }
}

void ProfileDrawing::showPrintedRoots(const Plots& plots) {
  const std::vector<PlotPrintedRoot> roots = plots.printedRoots(kind_);
  resizeLines(printedLines_, roots.size());
  printedDots_->data()->clear();
  const QColor colour = toQColor(styleOf(MarkKind::ApparentRidge, look_.palette).colour);
  const ProfileQuantity main = plots.quantitiesOf(kind_).back();
  for (std::size_t i = 0; i < roots.size(); ++i) {
    standAt(*printedLines_[i], roots[i].x);
    printedLines_[i]->setPen(QPen(colour, PrintedRootStyle{}.line * look_.scale, Qt::DashLine));
    const double y =
        std::clamp(plots.valueAt(roots[i], main).value_or(axis_.high), axis_.low, axis_.high);
    printedDots_->addData(roots[i].x, onAxis(y));
  }
}

std::vector<QPointF> ProfileDrawing::printedRoots() const {
  std::vector<QPointF> places;
  for (const QCPGraphData& at : *printedDots_->data()) places.emplace_back(at.key, at.value);
  return places;
}

QCPGraph& ProfileDrawing::symbolsOf(MarkKind kind, bool visible) {
  QCPGraph*& graph = symbols_[{kind, visible}];
  if (!graph) {
    graph = plot_.addGraph();
    graph->setLayer("symbols");
    graph->setLineStyle(QCPGraph::lsNone);
    graph->removeFromLegend();
    graph->setScatterStyle(symbolStyle(kind, visible, look_));
  }
  return *graph;
}

void ProfileDrawing::placeSymbols(const Plots& plots) {
  for (auto& [key, graph] : symbols_) graph->data()->clear();
  const ProfileQuantity main = plots.quantitiesOf(kind_).back();
  for (const PlotMark& mark : plots.marks()) {
    // Where the value is infinite or off the axis, at the edge towards it.
    const double y =
        std::clamp(plots.valueAt(mark, main).value_or(axis_.high), axis_.low, axis_.high);
    symbolsOf(mark.kind, mark.visible).addData(mark.x, onAxis(y));
  }
}

void ProfileDrawing::showRange(const Plots& plots) {
  const Plots::Range shown = plots.range();
  plot_.xAxis->setRange(shown.low, shown.high);
  const double linear = axis_.linear;
  axis_ = plots.axisOf(kind_);
  if (axis_.linear != linear) showLines(plots);  // another unit bends them
  plot_.yAxis->setRange(onAxis(axis_.low), onAxis(axis_.high));
  showTicks();
  placeSymbols(plots);
  showPrintedRoots(plots);
  plot_.yAxis->setLabel(look_.onPaper ? heading() : QString());
}

QString ProfileDrawing::heading() const {
  const QString title = titleOf(kind_);
  switch (axis_.scale) {
    case PlotAxis::Scale::Linear:
      break;
    case PlotAxis::Scale::Log:
      return ProfileWords::tr("%1, log").arg(title);
    case PlotAxis::Scale::Asinh:
      return ProfileWords::tr("%1, asinh, linear to ±%2")
          .arg(title, powerText(static_cast<int>(std::lround(std::log10(axis_.linear)))));
  }
  return title;
}

void ProfileDrawing::showTicks() {
  const double textHeight = QFontMetrics(plot_.font()).height();
  const int labels =
      std::max(2, static_cast<int>(plot_.axisRect()->height() / (kTickSpacing * textHeight)));
  if (axis_.scale == PlotAxis::Scale::Linear) {
    const QSharedPointer<QCPAxisTicker> ticker(new QCPAxisTicker);
    ticker->setTickCount(std::min(labels, 5));
    plot_.yAxis->setTicker(ticker);
    return;
  }
  const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
  const auto decade = [](double y) { return static_cast<int>(std::floor(std::log10(y))); };
  if (axis_.scale == PlotAxis::Scale::Log) {
    const int first = decade(axis_.low), last = decade(axis_.high) + 1;
    const int step = std::max(1, (last - first + labels - 1) / labels);
    for (int e = first; e <= last; ++e) {
      if (e % step == 0) ticker->addTick(std::pow(10.0, e), powerText(e));
    }
  } else {
    const double perUnit = plot_.axisRect()->height() / (onAxis(axis_.high) - onAxis(axis_.low));
    ticker->addTick(0.0, QStringLiteral("0"));
    double lastTick = 0.0;
    const double most = std::max(std::abs(axis_.low), std::abs(axis_.high));
    for (int e = decade(axis_.linear * 1.5); e <= decade(most); ++e) {
      const double at = onAxis(std::pow(10.0, e));
      if ((at - lastTick) * perUnit < kTickSpacing * textHeight) continue;
      lastTick = at;
      ticker->addTick(at, signedPower(1.0, e));
      ticker->addTick(-at, signedPower(-1.0, e));
    }
  }
  plot_.yAxis->setTicker(ticker);
}

void ProfileDrawing::showProbe(const Plots& plots) {
  const auto x = plots.probeX();
  const bool shown = x && !look_.onPaper;
  probeLine_->setVisible(shown);
  probeDots_->data()->clear();
  if (!shown) return;
  for (QCPItemPosition* point : {probeLine_->point1, probeLine_->point2}) {
    point->setTypeX(QCPItemPosition::ptPlotCoords);
    point->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  probeLine_->point1->setCoords(*x, 0.0);
  probeLine_->point2->setCoords(*x, 1.0);
  const bool positive = axis_.scale == PlotAxis::Scale::Log;
  for (const ProfileQuantity quantity : plots.quantitiesOf(kind_)) {
    const auto y = plots.probeValue(quantity);
    if (y && (!positive || *y > 0.0)) probeDots_->addData(*x, onAxis(*y));
  }
}

std::vector<std::vector<QPointF>> ProfileDrawing::linesOf(ProfileQuantity quantity) const {
  std::vector<std::vector<QPointF>> lines;
  const auto found = curves_.find(quantity);
  if (found == curves_.end()) return lines;
  bool lifted = true;
  for (const QCPCurveData& point : *found->second->data()) {
    if (std::isnan(point.key)) {
      lifted = true;
      continue;
    }
    if (lifted) lines.emplace_back();
    lifted = false;
    lines.back().emplace_back(point.key, point.value);
  }
  return lines;
}

std::optional<double> ProfileDrawing::probeX() const {
  if (!probeLine_->visible()) return std::nullopt;
  return probeLine_->point1->key();
}

}  // namespace flatland::ui
