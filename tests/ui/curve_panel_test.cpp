// SPDX-License-Identifier: GPL-3.0-or-later
// The panel Curve and the menu Curve > New, by mouse and keys.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>

#include "tests/ui/support_window.h"
#include "ui/commands/scene_commands.h"
#include "ui/panels/marked_slider.h"

namespace flatland::ui {

class CurvePanelTest : public QObject {
  Q_OBJECT

 private slots:
  void everyKindCanBeAddedAndConverted();
  void aSliderDragIsOneStepAndTheCanvasFollows();
  void aTypedNumberSetsAParameter();
  void theEllipseMarksItsBifurcation();
  void aFormulaIsTypedAndItsErrorsAreSaid();
  void whatMakesNoSenseInTheEndIsNoStep();
  void anErrorOfTheDomainStandsUnderTheEndThatWasTyped();
  void aNewCurveIsProbedSelectedAndInView();
  void weightsAreTyped();
  void aCurveWithoutPointsIsDraggedAsAWhole();
  void aDoubleClickAddsAKnot();

 private:
  static const Curve& last(WindowDriver& d) { return d.scene().curves.back().shape; }
  static const FormulaCurve& formula(WindowDriver& d) { return std::get<FormulaCurve>(last(d)); }
  static double parameter(WindowDriver& d, std::size_t i) {
    return formula(d).family()->parameters[i];
  }
  static void type(QWidget& field, const QString& text) {
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
  }
};

void CurvePanelTest::everyKindCanBeAddedAndConverted() {
  WindowDriver d;
  for (const char* kind : {"bezier", "bspline", "rational", "circle", "ellipse", "parabola", "sine",
                           "gaussian", "superellipse", "lissajous", "cycloid", "formula"}) {
    const std::size_t before = d.scene().curves.size();
    d.trigger((std::string("curve.new.") + kind).c_str());
    QCOMPARE(d.scene().curves.size(), before + 1);
    const Curve curve = last(d);
    auto& convert = d.child<QPushButton>("curve.convert");
    QCOMPARE(convert.isVisible(), !std::holds_alternative<BezierChain>(curve));
    if (!convert.isVisible()) continue;
    QTest::mouseClick(&convert, Qt::LeftButton);
    d.settle();
    const auto& chain = std::get<BezierChain>(last(d));
    const double size = boundsOf(curve).diagonal();
    for (const Vec2& p : sampledPoints(curve, 16)) {
      QVERIFY2(nearestPoint(chain, p).distance <= 1e-6 * size, kind);
    }
    d.document().undoStack().undo();
    QVERIFY(last(d) == curve);
    d.document().undoStack().undo();
    QCOMPARE(d.scene().curves.size(), before);
  }
}

void CurvePanelTest::aSliderDragIsOneStepAndTheCanvasFollows() {
  WindowDriver d;
  d.trigger("curve.new.ellipse");
  auto& slider = d.child<MarkedSlider>("curve.slider.b");
  EventCounter paints(d.canvas(), QEvent::Paint);
  const int steps = d.document().undoStack().count();
  const double before = parameter(d, 1);
  const int y = slider.height() / 2;
  const auto x = [&](double share) { return static_cast<int>(share * slider.width()); };
  const int start = x((before - 0.1) / 2.9);
  QTest::mousePress(&slider, Qt::LeftButton, {}, {start, y});
  int previous = paints.count();
  for (const int step : {10, 20, 40}) {
    QTest::mouseMove(&slider, QPoint(start + step, y));
    QMouseEvent move(QEvent::MouseMove, QPointF(start + step, y),
                     slider.mapToGlobal(QPointF(start + step, y)), Qt::NoButton, Qt::LeftButton,
                     {});
    QCoreApplication::sendEvent(&slider, &move);
    d.settle();
    QVERIFY(paints.count() > previous);
    previous = paints.count();
  }
  QTest::mouseRelease(&slider, Qt::LeftButton, {}, {start + 40, y});
  QVERIFY(parameter(d, 1) > before);
  QCOMPARE(d.document().undoStack().count(), steps + 1);
  d.document().undoStack().undo();
  QCOMPARE(parameter(d, 1), before);
  QCOMPARE(d.child<QDoubleSpinBox>("curve.number.b").value(), before);
  // By keys too.
  slider.setFocus();
  d.key(Qt::Key_Right);
  QVERIFY(parameter(d, 1) > before);
}

void CurvePanelTest::aTypedNumberSetsAParameter() {
  WindowDriver d;
  d.trigger("curve.new.superellipse");
  auto& number = d.child<QDoubleSpinBox>("curve.number.n");
  type(number, "2.5");
  d.key(Qt::Key_Return);
  QCOMPARE(parameter(d, 2), 2.5);
  QCOMPARE(d.child<MarkedSlider>("curve.slider.n").value(), 167);
}

void CurvePanelTest::theEllipseMarksItsBifurcation() {
  WindowDriver d;
  d.trigger("curve.new.ellipse");
  auto& slider = d.child<MarkedSlider>("curve.slider.b");
  QVERIFY(slider.mark().has_value());
  const double marked = 0.1 + 2.9 * *slider.mark() / 1000.0;
  QVERIFY(std::abs(marked - std::sqrt(1.5)) < 2e-3);
  QVERIFY(d.child<QLabel>("curve.note").text().contains("1.2247"));
  // It goes with a.
  auto& number = d.child<QDoubleSpinBox>("curve.number.a");
  type(number, "2");
  d.key(Qt::Key_Return);
  QVERIFY(std::abs(0.1 + 2.9 * *slider.mark() / 1000.0 - 2.0 * std::sqrt(1.5)) < 2e-3);
}

void CurvePanelTest::aFormulaIsTypedAndItsErrorsAreSaid() {
  WindowDriver d;
  d.trigger("curve.new.formula");
  auto& x = d.child<QLineEdit>("curve.formula.x");
  auto& error = d.child<QLabel>("curve.error.x");
  QVERIFY(!error.isVisible());
  const int steps = d.document().undoStack().count();
  type(x, "2*cos(t)");
  d.settle();
  QCOMPARE(formula(d).typed()->x, std::string("2*cos(t)"));
  QVERIFY(!error.isVisible());
  QVERIFY((pointAt(last(d), 0.0) - formula(d).at() - Vec2(2.0, 0.0)).norm() < 1e-14);
  type(x, "2*cos(t) +");
  QVERIFY(error.isVisible());
  QVERIFY2(error.text().contains("column 11"), qPrintable(error.text()));
  // The curve is that of the last text that could be read.
  QCOMPARE(QString::fromStdString(formula(d).typed()->x).trimmed(), QString("2*cos(t)"));
  QCOMPARE(x.text(), QString("2*cos(t) +"));  // what was typed stays
  type(x, "2*cos(t)");
  type(d.child<QLineEdit>("curve.formula.constants"), "a = x");
  QVERIFY(d.child<QLabel>("curve.error.constants").isVisible());
  QCOMPARE(d.document().undoStack().index(), steps + 1);
  d.document().undoStack().undo();
  QCOMPARE(d.document().undoStack().index(), steps);
  QVERIFY(x.text().contains("a*cos(3*t)"));
  QVERIFY(!error.isVisible());
}

void CurvePanelTest::whatMakesNoSenseInTheEndIsNoStep() {
  WindowDriver d;
  d.trigger("curve.new.formula");
  auto& x = d.child<QLineEdit>("curve.formula.x");
  const std::string before = formula(d).typed()->x;
  const int steps = d.document().undoStack().count();
  // Half of it, "2", is a formula too: a preview, until it is known what was meant.
  type(x, "2*q(t)");
  QVERIFY(d.child<QLabel>("curve.error.x").isVisible());
  QTest::keyClick(&x, Qt::Key_Return);
  d.settle();
  QCOMPARE(formula(d).typed()->x, before);
  QCOMPARE(d.document().undoStack().count(), steps);
  QCOMPARE(x.text(), QString("2*q(t)"));  // to be mended
  QVERIFY(d.child<QLabel>("curve.error.x").isVisible());
  type(x, "2*cos(t)");
  QTest::keyClick(&x, Qt::Key_Return);
  QCOMPARE(formula(d).typed()->x, std::string("2*cos(t)"));
  QCOMPARE(d.document().undoStack().count(), steps + 1);
  // Leaving the field counts as Return; a new word is a step of its own.
  type(x, "3*cos(t) +");
  d.child<QLineEdit>("curve.formula.y").setFocus();
  d.settle();
  QCOMPARE(formula(d).typed()->x, std::string("2*cos(t)"));
  QCOMPARE(d.document().undoStack().count(), steps + 1);
}

void CurvePanelTest::anErrorOfTheDomainStandsUnderTheEndThatWasTyped() {
  WindowDriver d;
  d.trigger("curve.new.formula");
  type(d.child<QLineEdit>("curve.formula.from"), "7");
  QVERIFY(d.child<QLabel>("curve.error.from").isVisible());
  QVERIFY(!d.child<QLabel>("curve.error.to").isVisible());
  type(d.child<QLineEdit>("curve.formula.from"), "1");
  QVERIFY(!d.child<QLabel>("curve.error.from").isVisible());
  type(d.child<QLineEdit>("curve.formula.to"), "0");
  QVERIFY(d.child<QLabel>("curve.error.to").isVisible());
  QVERIFY(!d.child<QLabel>("curve.error.from").isVisible());
}

void CurvePanelTest::aNewCurveIsProbedSelectedAndInView() {
  for (const double angle : {0.0, 90.0, 200.0}) {
    WindowDriver d;
    d.window().setGeometry(40, 40, 1280, 800);
    d.document().push(std::make_unique<SetView>(d.document(), View{angle, std::nullopt}));
    for (const char* kind : {"ellipse", "formula", "bezier"}) {
      const Scene before = d.scene();
      d.trigger((std::string("curve.new.") + kind).c_str());
      const std::size_t index = d.scene().curves.size() - 1;
      QVERIFY(d.window().probe().place());
      QCOMPARE(d.window().probe().place()->curve, index);
      QCOMPARE(*d.window().selection().currentCurve(), index);
      QCOMPARE(*d.window().plots().curve(), index);
      // Whole in view, and beside the others: their boxes do not meet.
      const Bounds own = boundsOf(last(d)), others = boundsOf(before);
      QVERIFY(d.canvas().rect().contains(d.at(own.low)));
      QVERIFY(d.canvas().rect().contains(d.at(own.high)));
      QVERIFY((own.low.array() > others.high.array()).any() ||
              (own.high.array() < others.low.array()).any());
    }
    // Also where the curves before it have gone.
    while (!d.scene().curves.empty()) d.trigger("curve.remove");
    QVERIFY(!d.window().probe().place());
    d.trigger("curve.new.circle");
    QVERIFY(d.window().probe().place());
    d.trigger("curve.new.sine");
    d.trigger("edit.undo");
    QVERIFY2(d.window().probe().place(), "where a curve is left");
  }
}

void CurvePanelTest::weightsAreTyped() {
  WindowDriver d;
  d.trigger("curve.new.rational");
  auto& table = d.child<QTableWidget>("curve.weights");
  const auto weight = [&] { return std::get<RationalBezier>(last(d)).weights()[1]; };
  const double before = weight();
  const auto enter = [&](const QString& text) {
    table.setFocus();
    table.setCurrentCell(1, 0);
    table.editItem(table.item(1, 0));
    auto* edit = table.findChild<QLineEdit*>();
    QVERIFY(edit);
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    d.settle();
  };
  enter("-1");
  QCOMPARE(weight(), before);
  enter("2.5");
  QCOMPARE(weight(), 2.5);
  QCOMPARE(table.item(1, 0)->text(), QString("2.5"));
}

void CurvePanelTest::aCurveWithoutPointsIsDraggedAsAWhole() {
  WindowDriver d;
  d.trigger("file.new");
  d.trigger("curve.new.circle");
  d.canvasKey(Qt::Key_F);
  const Vec2 before = formula(d).at();
  const int steps = d.document().undoStack().count();
  const QPoint from = d.at(pointAt(last(d), 0.3));
  d.drag(from, from + QPoint(40, 0));
  QVERIFY(formula(d).at().x() > before.x());
  QCOMPARE(d.document().undoStack().count(), steps + 1);
  d.document().undoStack().undo();
  QVERIFY(formula(d).at() == before);
}

void CurvePanelTest::aDoubleClickAddsAKnot() {
  WindowDriver d;
  d.trigger("curve.new.bspline");
  const Curve before = last(d);
  const QPoint place = d.at(pointAt(before, 2.45));
  QTest::mouseDClick(&d.canvas(), Qt::LeftButton, {}, place);
  d.settle();
  QCOMPARE(controlPoints(last(d)).size(), controlPoints(before).size() + 1);
  for (const Vec2& p : sampledPoints(before, 8)) {
    QVERIFY(nearestPoint(last(d), p).distance < 1e-12);
  }
  // Its control points can be dragged.
  const Vec2 point = controlPoints(last(d))[0];
  d.drag(d.at(point), d.at(point) + QPoint(15, 10));
  QVERIFY(controlPoints(last(d))[0] != point);
}

}  // namespace flatland::ui

QTEST_MAIN(flatland::ui::CurvePanelTest)
#include "curve_panel_test.moc"
