// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/glyph_dialog.h"

#include <QDialogButtonBox>
#include <QFontComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>

#include "flatland/io/input_error.h"
#include "ui/model/core_sentences.h"
#include "ui/model/core_words.h"

namespace flatland::ui {

/// Paints the curves of a scene as large as fits; nothing for an empty one.
class OutlineView : public QWidget {
 public:
  explicit OutlineView(QWidget* parent) : QWidget(parent) { setMinimumSize(220, 220); }

  void show(const Scene& scene) {
    scene_ = scene;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    const Bounds box = boundsOf(scene_);
    const double side = (box.high - box.low).maxCoeff();
    if (!(side > 0.0)) return;
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = 0.86 * std::min(width(), height()) / side;
    painter.translate(0.5 * width(), 0.5 * height());
    painter.scale(scale, -scale);
    const auto at = [](const Vec2& p) { return QPointF(p.x(), p.y()); };
    QPainterPath path;
    for (const SceneCurve& curve : scene_.curves) {
      path.moveTo(at(curve.chain().piece(0).points.front()));
      for (int i = 0; i < curve.chain().pieceCount(); ++i) {
        for (const Bezier& cubic : toCubics(curve.chain().piece(i), 1e-3 * side)) {
          Bezier raised = cubic;
          while (raised.degree() < 3) raised = elevated(raised);
          path.cubicTo(at(raised.points[1]), at(raised.points[2]), at(raised.points[3]));
        }
      }
    }
    QPen pen(palette().color(QPalette::Text), 2.0);
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.drawPath(path);
  }

 private:
  Scene scene_;
};

GlyphDialog::GlyphDialog(const GlyphName& start, QWidget* parent)
    : QDialog(parent),
      family_(new QFontComboBox(this)),
      character_(new QLineEdit(this)),
      outline_(new OutlineView(this)),
      message_(new QLabel(this)) {
  setObjectName("glyph");
  setWindowTitle(tr("Import glyph"));
  family_->setObjectName("glyph.family");
  family_->setFontFilters(QFontComboBox::ScalableFonts);
  family_->setToolTip(tr("The font whose letter is taken"));
  family_->setAccessibleName(tr("Font"));
  if (!start.family.isEmpty()) family_->setCurrentFont(QFont(start.family));
  character_->setObjectName("glyph.character");
  character_->setToolTip(tr("The letter, or its code as U+0061"));
  character_->setAccessibleName(tr("Character"));
  character_->setMaxLength(8);
  character_->setText(QString::fromUcs4(&start.character, 1));
  character_->selectAll();
  outline_->setObjectName("glyph.outline");
  outline_->setAccessibleName(tr("Outline of the letter"));
  message_->setObjectName("glyph.message");
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  accept_->setText(tr("Import"));
  accept_->setObjectName("glyph.import");
  accept_->setToolTip(tr("Add the outline to the scene"));

  auto* layout = new QFormLayout(this);
  layout->addRow(tr("&Font:"), family_);
  layout->addRow(tr("&Character:"), character_);
  layout->addRow(outline_);
  layout->addRow(message_);
  layout->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(family_, &QComboBox::currentTextChanged, this, &GlyphDialog::refresh);
  connect(character_, &QLineEdit::textChanged, this, &GlyphDialog::refresh);
  character_->setFocus();
  refresh();
}

GlyphName GlyphDialog::name() const {
  return glyphNamed("glyph:" + family_->currentText().toStdString() + ":" +
                    character_->text().toStdString());
}

void GlyphDialog::refresh() {
  ImportedScene imported;
  QString message;
  try {
    imported = glyphScene(name());
    message = importForPeople(imported);
  } catch (const InputError& error) {
    message = coreWords(error.reason());
  }
  outline_->show(imported.scene);
  message_->setText(message);
  accept_->setEnabled(!imported.scene.curves.empty());
}

}  // namespace flatland::ui
