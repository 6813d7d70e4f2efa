// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/SaveDialog.h"
#include "ui/values/Words.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

#include <algorithm>

namespace toile::ui {
namespace {

/// ".obj", ".ply" of "Wavefront OBJ (*.obj);;PLY (*.ply)".
QStringList endingsOf(const QString& kinds) {
    static const QRegularExpression ending(QStringLiteral(R"(\*(\.\w+))"));
    QStringList endings;
    for (auto match = ending.globalMatch(kinds); match.hasNext();) endings << match.next().captured(1);
    return endings;
}

QString withEnding(const QString& path, const QString& kinds, const QString& chosenKind) {
    const auto hasIt = [&](const QString& ending) { return path.endsWith(ending, Qt::CaseInsensitive); };
    return std::ranges::any_of(endingsOf(kinds), hasIt) ? path : path + endingsOf(chosenKind).value(0);
}

bool mayReplace(QWidget& window, const QString& file) {
    QMessageBox box(QMessageBox::Warning, tr("Replace the file?"),
                    tr("%1 already exists.").arg(QFileInfo(file).fileName()), QMessageBox::Cancel, &window);
    box.setObjectName(QStringLiteral("replaceFile"));
    box.setInformativeText(tr("Replacing it overwrites what is in it."));
    const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace;
}

} // namespace

QString fileToWrite(QWidget& window, const QString& title, const QString& proposal, const QString& kinds) {
    QFileDialog dialog(&window, title, proposal, kinds);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite); // it would ask about the name as it was typed
    while (dialog.exec() == QDialog::Accepted) {
        const QString file = withEnding(dialog.selectedFiles().value(0), kinds, dialog.selectedNameFilter());
        if (!QFileInfo::exists(file) || mayReplace(window, file)) return file;
    }
    return {};
}

} // namespace toile::ui
