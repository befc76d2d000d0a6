// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/edit_controller.h"

#include "ui/commands/curve_commands.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/core_words.h"
#include "ui/model/new_curves.h"

namespace flatland::ui {

namespace {

/// Back to the scene as it was started or opened.
class Reset : public ReplaceScene {
 public:
  using ReplaceScene::ReplaceScene;
};

}  // namespace

EditController::EditController(const CanvasModels& models, QObject* parent)
    : QObject(parent), models_(models) {}

void EditController::removePoints() {
  const std::set<PointRef>& points = models_.selection.points();
  if (points.empty()) {
    emit refused(tr("Nothing is selected. Click a point or press Tab, then Delete."));
    return;
  }
  PointRemoval removal = withoutPoints(models_.document.scene(), points);
  if (!removal.possible()) {
    emit refused(coreWords(removal.reason));
    return;
  }
  models_.document.push(std::make_unique<RemovePoints>(models_.document, std::move(removal)));
  models_.selection.clear();
}

void EditController::addCurve() { add(models_.stage.newCurve(models_.viewport.centre())); }

void EditController::addCurve(const QString& kind) {
  add({.shape = newCurve(kind, models_.viewport.centre(), models_.stage.radius())});
}

void EditController::add(SceneCurve curve) {
  curve.shape = translated(curve.shape, models_.stage.besideTheOthers(curve.shape));
  models_.document.push(std::make_unique<AddCurve>(models_.document, curve));
  const std::size_t index = models_.document.scene().curves.size() - 1;
  std::set<PointRef> points;
  for (std::size_t i = 0; i < controlPoints(curve.shape).size(); ++i) points.insert({index, i});
  models_.selection.setPoints(std::move(points));
  models_.selection.setCurrentCurve(index);
  models_.probe.setPlace(models_.probe.home(index));
  if (!models_.viewport.holds(boundsOf(curve.shape))) {
    models_.stage.renew();
    models_.viewport.fit(models_.stage.fitBox());
  }
}

void EditController::removeCurve() {
  const auto curve = models_.selection.currentCurve();
  if (!curve) return;
  models_.selection.clear();
  models_.document.push(std::make_unique<RemoveCurve>(models_.document, *curve));
}

void EditController::raiseDegree() {
  const auto curve = models_.selection.currentCurve();
  if (!curve) return;
  const Curve& shape = models_.document.scene().curves[*curve].shape;
  if (const EditResult raised = withRaisedDegree(shape); !raised.curve) {
    emit refused(coreWords(raised.reason));
    return;
  }
  if (degreeOf(shape) >= kMaxDegree) {
    emit refused(tr("The curve has degree %1 already, the highest that can be edited here.")
                     .arg(kMaxDegree));
    return;
  }
  models_.selection.clear();
  models_.document.push(std::make_unique<RaiseDegree>(models_.document, *curve));
}

void EditController::flipNormal() {
  const auto curve = models_.selection.currentCurve();
  if (curve) models_.document.push(std::make_unique<FlipNormal>(models_.document, *curve));
}

void EditController::reset() {
  models_.document.push(
      std::make_unique<Reset>(models_.document, models_.document.origin(), tr("reset")));
}

void EditController::togglePerspective(bool on) {
  View view = models_.document.scene().view;
  if (view.distance.has_value() == on) return;
  view.distance = on ? std::optional(models_.stage.suggestedDistance()) : std::nullopt;
  models_.document.push(std::make_unique<SetView>(models_.document, view));
}

void EditController::setAngle(double angleDeg) {
  View view = models_.document.scene().view;
  view.angleDeg = normalizedDeg(angleDeg);
  models_.document.push(std::make_unique<SetView>(models_.document, view));
}

}  // namespace flatland::ui
