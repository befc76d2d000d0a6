// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/surface_export_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/app/export_fields.h"

namespace flatland::ui {

SurfaceExportDialog::SurfaceExportDialog(const ExportSettings& settings, const QString& suffix,
                                         QWidget* parent)
    : QDialog(parent), settings_(settings) {
  setObjectName("surface-export");
  setWindowTitle(tr("Export surface"));
  fields_ = new ExportFields({{tr("SVG, the lines as vectors"), "svg"},
                              {tr("PDF, the lines as vectors"), "pdf"},
                              {tr("TikZ, the lines for LaTeX"), "tex"},
                              {tr("PNG, the picture with its shading"), "png"},
                              {tr("PLY, curvature at the vertices"), "ply", false},
                              {tr("CSV, curvature at the vertices"), "csv", false},
                              {tr("JSON, cameras for flatland lines"), "json", false}},
                             suffix, settings, this);
  auto* note = new QLabel(tr("Lines keep their width whatever the size."), this);
  note->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* go = buttons->addButton(tr("&Export…"), QDialogButtonBox::AcceptRole);
  go->setObjectName("export.go");
  go->setToolTip(tr("Choose a file and write it"));
  go->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(fields_);
  layout->addWidget(note);
  layout->addStretch(1);
  layout->addWidget(buttons);
}

ExportSettings SurfaceExportDialog::settings() const {
  ExportSettings settings = settings_;
  fields_->readInto(settings);
  return settings;
}

QString SurfaceExportDialog::suffix() const { return fields_->suffix(); }

}  // namespace flatland::ui
