// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a mesh and estimating its curvature in the real window: what giving up leaves, and what
// happens meanwhile.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>

#include "tests/ui/support_window.h"
#include "ui/app/file_controller.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/view3d/surface_area.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kPatienceMs = 60000;
constexpr char kSmall[] = "torus:40";
constexpr char kLarge[] = "torus:500";  // takes a second or so

}  // namespace

class SurfaceReadingTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  /// Where no surface is shown yet the window says so above the curves.
  void readingTheFirstMeshIsSaid() {
    auto& row = driver_->child<QWidget>("reading.progress");
    QVERIFY(!row.isVisible());
    driver_->window().surfaces().openSolid(kLarge);
    QVERIFY(source().isReading());
    QVERIFY(row.isVisible());
    QCOMPARE(row.findChild<QLabel*>()->text(), QStringLiteral("Reading the mesh"));
    QVERIFY(!driver_->window().surfaceArea().isVisible());
    QSignalSpy said(&driver_->window().surfaces(), &SurfaceController::said);
    press("reading.cancel");
    QCOMPARE(said.count(), 1);
    QCOMPARE(said.takeFirst().front().toString(), QStringLiteral("Stopped reading torus:500."));
    QVERIFY(!source().isBusy());
    QVERIFY(!row.isVisible());
    driver_->settle();
    QVERIFY(!driver_->scene().surface);
    // Once it is there its own panel says what goes on.
    openUntilEstimating(kLarge);
    QVERIFY(!row.isVisible());
    QVERIFY(driver_->child<QWidget>("surface.progress").isVisible());
    driver_->window().surfaces().openSolid(kSmall);
    QVERIFY(source().isReading());
    QVERIFY(!row.isVisible());
    press("surface.cancel");
    QVERIFY(said.takeFirst().front().toString().contains("The surface before stays"));
    QVERIFY(driver_->surfaceQuiet());
  }

  void aMeshThatFailsLeavesNoRow() {
    auto& row = driver_->child<QWidget>("reading.progress");
    driver_->window().files().openFile(driver_->path("none.ply"));
    QVERIFY(row.isVisible());
    QTRY_VERIFY(!row.isVisible());
    QVERIFY(driver_->child<QLabel>("message.text").text().contains("none.ply"));
  }

  void whatWasGivenUpGoesOn() {
    openUntilEstimating(kLarge);
    press("surface.cancel");
    QVERIFY(!source().isBusy());
    QVERIFY(!source().surface()->fields);
    QVERIFY(button("surface.go-on").isVisible());
    QVERIFY(!button("surface.cancel").isVisible());
    // Nothing that has to do with it brings it back.
    changeStyle();
    QVERIFY(!source().isBusy());
    press("surface.go-on");
    QVERIFY(source().isBusy());
    QVERIFY(button("surface.cancel").isVisible());
    QVERIFY(!button("surface.go-on").isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(source().surface()->fields, kPatienceMs);
    QVERIFY(!button("surface.go-on").isVisible());
  }

  void keysGiveUpAndGoOn() {
    openUntilEstimating(kLarge);
    button("surface.cancel").setFocus();
    driver_->key(Qt::Key_Space);
    QVERIFY(!source().isBusy());
    button("surface.go-on").setFocus();
    driver_->key(Qt::Key_Space);
    QVERIFY(source().isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(source().surface()->fields, kPatienceMs);
  }

  void anotherSmoothnessBeginsAgain() {
    openUntilEstimating(kLarge);
    press("surface.cancel");
    QVERIFY(!source().isBusy());
    smoother();
    QVERIFY(source().isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(source().surface()->fields, kPatienceMs);
    QCOMPARE(source().surface()->fitScale, 1.5);
  }

  void openingAgainBeginsAgain() {
    openUntilEstimating(kLarge);
    press("surface.cancel");
    driver_->window().surfaces().openSolid(kLarge);
    QTRY_VERIFY_WITH_TIMEOUT(source().surface()->fields, kPatienceMs);
  }

  void anEstimateGivenUpStaysSo() {
    driver_->window().surfaces().openSolid(kLarge);
    QVERIFY(driver_->surfaceQuiet());
    smoother();
    QVERIFY(source().isBusy());
    press("surface.cancel");
    QVERIFY(!source().isBusy());
    changeStyle();
    QVERIFY(!source().isBusy());
    QCOMPARE(source().surface()->fitScale, 1.0);
    QVERIFY(source().surface()->fields);
    QVERIFY(button("surface.go-on").isVisible());
    // Back to what is there: nothing is wanting.
    QTest::keyClick(&scale(), Qt::Key_Down);
    driver_->settle();
    QVERIFY(!source().isBusy());
    QVERIFY(!button("surface.go-on").isVisible());
  }

  void smoothnessDoesNotStopAnOpening() {
    driver_->window().surfaces().openSolid(kSmall);
    QVERIFY(driver_->surfaceQuiet());
    driver_->window().surfaces().openSolid(kLarge);
    QVERIFY(source().isReading());
    scale().setValue(2.0);  // before the events that would show the large one
    QVERIFY(driver_->surfaceQuiet());
    QCOMPARE(driver_->scene().surface->mesh, std::string("solid:") + kLarge);
    QCOMPARE(source().surface()->fitScale, 2.0);
    QVERIFY(source().surface()->fields);
  }

  void anOpeningEndsWithItsScene() {
    driver_->window().surfaces().openSolid(kSmall);
    QVERIFY(driver_->surfaceQuiet());
    const QString file = driver_->path("scene.json");
    QVERIFY(driver_->window().files().saveTo(file));
    driver_->window().surfaces().openSolid(kLarge);
    driver_->window().files().openFile(file);
    QVERIFY(!source().isReading());
    QVERIFY(driver_->surfaceQuiet());
    QCOMPARE(driver_->scene().surface->mesh, std::string("solid:") + kSmall);
    QVERIFY(!driver_->document().isModified());
  }

  void aSweepLeavesAnOpeningAlone() {
    driver_->trigger("surface.extrude");
    QVERIFY(driver_->surfaceQuiet());
    QTRY_VERIFY_WITH_TIMEOUT(source().surface() && source().surface()->swept, kPatienceMs);
    int swept = 0, forgotten = 0;
    connect(&source(), &SurfaceSource::changed, this, [&] {
      if (!source().surface() || !source().surface()->swept) return;
      ++swept;
      forgotten += !source().isReading();
    });
    driver_->window().surfaces().openSolid("torus:1000");
    SurfaceSetting setting = *driver_->scene().surface;
    setting.swept->amount *= 1.1;
    push(setting);
    QTRY_VERIFY_WITH_TIMEOUT(driver_->scene().surface->mesh == "solid:torus:1000", kPatienceMs);
    QVERIFY(swept > 0);
    QCOMPARE(forgotten, 0);
    driver_->window().surfaceModels().source.cancel();
  }

 private:
  SurfaceSource& source() { return driver_->window().surfaceModels().source; }
  QToolButton& button(const char* name) { return driver_->child<QToolButton>(name); }
  QDoubleSpinBox& scale() { return driver_->child<QDoubleSpinBox>("surface.scale"); }
  void press(const char* name) {
    QTest::mouseClick(&button(name), Qt::LeftButton);
    driver_->settle();
  }
  void smoother() {
    QTest::keyClick(&scale(), Qt::Key_Up);
    driver_->settle();
  }
  void openUntilEstimating(const char* solid) {
    driver_->window().surfaces().openSolid(solid);
    QTRY_VERIFY_WITH_TIMEOUT(source().surface(), kPatienceMs);
    QVERIFY(source().isBusy() && !source().isReading());
    QTRY_VERIFY(button("surface.cancel").isVisible());
  }
  void push(const SurfaceSetting& setting) {
    driver_->document().push(std::make_unique<SetSurface>(driver_->document(), setting, "edit"));
    driver_->settle();
  }
  void changeStyle() {
    SurfaceSetting setting = *driver_->scene().surface;
    setting.style = "paper";
    push(setting);
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(SurfaceReadingTest)
#include "surface_reading_test.moc"
