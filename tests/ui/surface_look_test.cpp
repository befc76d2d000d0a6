// SPDX-License-Identifier: GPL-3.0-or-later
// How the surface is shown, by mouse and keys: shading, hidden lines, counts of levels, cameras;
// and the picture of OpenGL against the painted one of files.
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <cmath>
#include <set>

#include "tests/ui/support_window.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/surface_look.h"
#include "ui/model/theme.h"
#include "ui/view3d/gl_canvas.h"
#include "ui/view3d/soft_canvas.h"
#include "ui/view3d/surface_area.h"
#include "ui/view3d/surface_overlay.h"
#include "ui/view3d/surface_picture.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kPatienceMs = 60000;

/// Mean difference of colour in the middle of two pictures, 0 to 255: words stand at the corners.
double difference(const QImage& a, const QImage& b) {
  double sum = 0.0;
  int count = 0;
  for (int y = a.height() / 4; y < 3 * a.height() / 4; ++y) {
    for (int x = a.width() / 4; x < 3 * a.width() / 4; ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      sum += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
             std::abs(p.blue() - q.blue());
      ++count;
    }
  }
  return sum / (3.0 * count);
}

/// What is drawn on light paper, in pixels.
double inkOf(const QImage& image) {
  double ink = 0.0;
  for (int y = image.height() / 4; y < 3 * image.height() / 4; ++y) {
    for (int x = image.width() / 4; x < 3 * image.width() / 4; ++x) {
      ink += 1.0 - qGray(image.pixel(x, y)) / 255.0;
    }
  }
  return ink;
}

}  // namespace

class SurfaceLookTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    driver_->window().surfaces().openSolid("torus:60");
    QVERIFY(driver_->surfaceQuiet());
  }
  void cleanup() { driver_.reset(); }

  /// While the camera moves the far side of what is closed is left out, and never what is seen.
  void aPictureInMotionIsTheSame_data() {
    QTest::addColumn<QString>("solid");
    for (const char* solid : {"torus:60", "saddle:40", "cylinder:40"})
      QTest::newRow(solid) << solid;
  }
  void aPictureInMotionIsTheSame() {
    if (!GlCanvas::possible()) QSKIP("no OpenGL");
    QFETCH(QString, solid);
    driver_->window().surfaces().openSolid(solid);
    QVERIFY(driver_->surfaceQuiet());
    withoutLines();
    for (const double tilt : {0.5, -0.6}) {
      for (const bool perspective : {false, true}) {
        SurfaceCamera camera = driver_->scene().surface->camera;
        camera.towards = Eigen::Vector3d(0.3, tilt, 0.5).normalized();
        if (perspective) camera.perspectiveDeg = 60.0;
        driver_->document().setCamera(camera);
        const QImage moving = canvas().grab().toImage();  // at once
        const SurfacePicture picture = pictureOf(driver_->window().surfaceModels());
        const double apart = difference(moving, paintSurface(picture, canvas().size()));
        QVERIFY2(apart < 2.5, qPrintable(QString::number(apart)));
      }
    }
  }

  /// Told once; from then on the surface is painted, and can be turned as before.
  void whenOpenGlFailsThePainterGoesOn() {
    if (!GlCanvas::possible()) QSKIP("no OpenGL");
    withoutLines();
    auto* gl = qobject_cast<GlCanvas*>(&canvas());
    QVERIFY(gl);
    QSignalSpy told(&driver_->window().surfaceArea(), &SurfaceArea::failed);
    emit gl->failed("it is gone");
    QTRY_VERIFY(qobject_cast<SoftCanvas*>(&canvas()));
    QCOMPARE(told.count(), 1);
    QTRY_COMPARE(driver_->window().findChildren<GlCanvas*>().size(), qsizetype{0});
    QCOMPARE(driver_->child<QLabel>("message.text").text(), QStringLiteral("it is gone"));
    QVERIFY(canvas().isVisible() && canvas().width() > 100);
    const SurfacePicture picture = pictureOf(driver_->window().surfaceModels());
    QTRY_VERIFY(difference(canvas().grab().toImage(), paintSurface(picture, canvas().size())) <
                1.0);
    const Eigen::Vector3d before = driver_->scene().surface->camera.towards;
    const QPoint middle = canvas().rect().center();
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&canvas(), middle + QPoint(40, 10));
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, middle + QPoint(40, 10));
    QVERIFY((driver_->scene().surface->camera.towards - before).norm() > 0.05);
    QCOMPARE(told.count(), 1);
  }

  /// One for all views, below them: over a surface it would hide it, or be lost on it.
  void theLegendOfColoursLiesBelowTheViews() {
    auto& strip = driver_->child<QWidget>("surface.colours");
    QVERIFY(!strip.isVisible());
    driver_->trigger("surface.compare.four");
    auto& style = driver_->child<QComboBox>("surface.style");
    style.setFocus();
    QTest::keyClick(&style, Qt::Key_End);
    QVERIFY(driver_->surfaceQuiet());
    QVERIFY(strip.isVisible());
    QCOMPARE(strip.toolTip(), strip.accessibleDescription());
    const SurfaceArea& area = driver_->window().surfaceArea();
    const auto rectOf = [&area](const QWidget& widget) {
      return QRect(widget.mapTo(&area, QPoint()), widget.size());
    };
    for (std::size_t pane = 0; pane < 4; ++pane) {
      QVERIFY(rectOf(*area.canvas(pane)).bottom() < rectOf(strip).top());
      // Nothing else is written where it once was.
      SurfaceOverlay& overlay = *area.overlay(pane);
      QImage words(overlay.size(), QImage::Format_ARGB32);
      words.fill(Qt::transparent);
      overlay.render(&words, {}, {}, QWidget::DrawChildren);
      int drawn = 0;
      for (int y = words.height() / 2; y < words.height(); ++y) {
        for (int x = words.width() / 2; x < words.width(); ++x) {
          drawn += qAlpha(words.pixel(x, y)) > 0;
        }
      }
      QCOMPARE(drawn, 0);
    }
    // It has the colours that the surface has, end to end.
    const VertexColours& colours = *driver_->window().surfaceModels().seen.seen()->colours;
    const QImage row = strip.grab().toImage();
    for (const double share : {0.01, 0.99}) {
      const Rgb end = colours.scale.at(share, themePalette());
      int near = 0;
      for (int x = 0; x < row.width(); ++x) {
        const QColor c = row.pixelColor(x, row.height() / 4);
        near +=
            std::abs(c.red() - end.r) + std::abs(c.green() - end.g) + std::abs(c.blue() - end.b) <
            12;
      }
      QVERIFY(near > 0);
    }
    QTest::keyClick(&style, Qt::Key_Home);
    QVERIFY(!strip.isVisible());
  }

  /// Each style by the keys of its box: OpenGL and the painter agree on all, and the styles differ.
  void paintersAgreeOnEveryShading() {
    if (!GlCanvas::possible()) QSKIP("no OpenGL");
    QVERIFY(qobject_cast<GlCanvas*>(&canvas()));
    // Coarse: triangles are seen where they are flat.
    driver_->window().surfaces().openSolid("torus:8");
    QVERIFY(driver_->surfaceQuiet());
    withoutLines();
    auto& style = driver_->child<QComboBox>("surface.style");
    style.setFocus();
    QTest::keyClick(&style, Qt::Key_Home);
    std::vector<QImage> seen;
    for (int i = 0; i < kSurfaceStyleCount; ++i) {
      if (i > 0) QTest::keyClick(&style, Qt::Key_Down);
      QVERIFY(driver_->surfaceQuiet());
      QCOMPARE(driver_->scene().surface->style, std::string(nameOf(static_cast<SurfaceStyle>(i))));
      const QImage gl = picture();
      const double apart = difference(gl, painted());
      QVERIFY2(apart < kSame, qPrintable(QStringLiteral("%1: %2").arg(i).arg(apart)));
      for (std::size_t k = 0; k < seen.size(); ++k) {
        const double other = difference(gl, seen[k]);
        QVERIFY2(other > kOther, qPrintable(QStringLiteral("%1, %2: %3").arg(i).arg(k).arg(other)));
      }
      seen.push_back(gl);
    }
  }

  void hiddenLinesAreLeftOutDashedOrShown() {
    setting([](SurfaceSetting& surface) { surface.style = "paper"; });
    SurfaceCamera oblique = driver_->scene().surface->camera;
    oblique.towards = Eigen::Vector3d(0.9, 0.25, 0.4).normalized();
    driver_->document().setCamera(oblique);
    QVERIFY(driver_->surfaceQuiet());
    auto& hidden = driver_->child<QComboBox>("families.hidden");
    hidden.setFocus();
    QTest::keyClick(&hidden, Qt::Key_Home);
    double before[2] = {};
    for (int i = 0; i < kHiddenLinesCount; ++i) {
      if (i > 0) QTest::keyClick(&hidden, Qt::Key_Down);
      QVERIFY(driver_->surfaceQuiet());
      QCOMPARE(driver_->scene().surface->hidden, std::string(nameOf(static_cast<HiddenLines>(i))));
      const double ink[2] = {inkOf(picture()), inkOf(painted())};
      for (int k = 0; k < 2; ++k) {
        QVERIFY2(ink[k] > 1.05 * before[k],
                 qPrintable(QStringLiteral("%1: %2 after %3").arg(i).arg(ink[k]).arg(before[k])));
        before[k] = ink[k];
      }
      QVERIFY2(std::abs(ink[0] / ink[1] - 1.0) < 0.15,
               qPrintable(QStringLiteral("%1: %2 and %3").arg(i).arg(ink[0]).arg(ink[1])));
    }
  }

  void soManyLevelsAsAreTyped() {
    const struct {
      LineFamily family;
      const char* box;
    } cases[] = {{LineFamily::Isophotes, "families.isophotes"},
                 {LineFamily::Topographic, "families.heights"}};
    for (const auto& [family, box] : cases) {
      setting([family](SurfaceSetting& surface) {
        SurfaceFamily look = familyOf(surface, family);
        look.on = true;
        surface = withFamily(surface, look);
      });
      auto& count = driver_->child<QSpinBox>(box);
      for (const int wanted : {3, 7}) {
        count.setFocus();
        count.selectAll();
        QTest::keyClicks(&count, QString::number(wanted));
        QTest::keyClick(&count, Qt::Key_Return);
        QVERIFY(driver_->surfaceQuiet());
        std::set<std::uint32_t> levels;
        const auto& seen = driver_->window().surfaceModels().seen.seen();
        for (const LineSegment& piece : seen->found->of(family)) levels.insert(piece.level);
        QCOMPARE(static_cast<int>(levels.size()), wanted);
      }
    }
  }

  void camerasAreKeptUsedAndForgotten() {
    auto& list = driver_->child<QListWidget>("surface.cameras");
    auto& keep = driver_->child<QPushButton>("surface.camera.keep");
    auto& forget = driver_->child<QPushButton>("surface.camera.forget");
    const auto look = [this](StandardView view) {
      driver_->document().setCamera(seenFrom(driver_->scene().surface->camera, view));
    };
    const auto row = [&list](int i) {
      QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                        list.visualItemRect(list.item(i)).center());
    };
    look(StandardView::Front);
    QTest::mouseClick(&keep, Qt::LeftButton);
    look(StandardView::Right);
    QTest::mouseClick(&keep, Qt::LeftButton);
    const std::vector<SavedCamera> both = driver_->scene().surface->savedCameras;
    QCOMPARE(both.size(), std::size_t{2});
    QVERIFY(!(both[0].camera == both[1].camera));
    QVERIFY(!forget.isEnabled());
    row(0);
    QVERIFY(forget.isEnabled());
    QTest::mouseClick(&forget, Qt::LeftButton);
    QCOMPARE(driver_->scene().surface->savedCameras.size(), std::size_t{1});
    QVERIFY(driver_->scene().surface->savedCameras[0] == both[1]);
    QCOMPARE(list.count(), 1);
    QVERIFY(!forget.isEnabled());
    driver_->document().undoStack().undo();
    QVERIFY(driver_->scene().surface->savedCameras == both);
    // By keys: the first is looked from again.
    list.setFocus();
    list.setCurrentRow(0);
    QTest::keyClick(&list, Qt::Key_Return);
    QVERIFY(driver_->scene().surface->camera == both[0].camera);
  }

 private:
  static constexpr double kSame = 1.5, kOther = 3.0;

  QWidget& canvas() { return *driver_->window().surfaceArea().canvas(); }
  /// By the window, when the camera has come to rest and edges are smooth.
  QImage picture() {
    QTest::qWait(400);
    driver_->settle();
    return canvas().grab().toImage().convertToFormat(QImage::Format_RGB32);
  }
  QImage painted() {
    return paintSurface(pictureOf(driver_->window().surfaceModels()), canvas().size());
  }
  void setting(const std::function<void(SurfaceSetting&)>& change) {
    SurfaceSetting surface = *driver_->scene().surface;
    change(surface);
    driver_->document().push(std::make_unique<SetSurface>(driver_->document(), surface, "edit"));
    QVERIFY(driver_->surfaceQuiet());
  }
  void withoutLines() {
    setting([](SurfaceSetting& surface) {
      for (const LineFamily family : allLineFamilies()) {
        SurfaceFamily look = familyOf(surface, family);
        look.on = false;
        surface = withFamily(surface, look);
      }
    });
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(SurfaceLookTest)
#include "surface_look_test.moc"
