// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/FileCommands.h"

#include "ui/values/Remarks.h"
#include "ui/window/MotionDialog.h"
#include "ui/window/SaveDialog.h"
#include "ui/window/TakeTyped.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

namespace toile::ui {
namespace {

constexpr int recentFiles = 8;
const QString recentKey = QStringLiteral("recentFiles");

} // namespace

FileCommands::FileCommands(Workbench& workbench, QWidget& window, DrapeWriter writeDrape, QStringList sampleFolders)
    : QObject(&window), workbench_(workbench), window_(window), writeDrape_(std::move(writeDrape)),
      sampleFolders_(std::move(sampleFolders)) {}

void FileCommands::startNew() {
    if (mayDiscard()) workbench_.startNew();
}

void FileCommands::open() {
    const QString path = QFileDialog::getOpenFileName(&window_, tr("Open"), QFileInfo(workbench_.path()).absolutePath(),
                                                      tr("Patterns (*.toile *.json);;Toile documents (*.toile);;"
                                                         "GarmentCode patterns (*.json);;All files (*)"));
    if (!path.isEmpty()) openFile(path);
}

bool FileCommands::openFile(const QString& path) {
    if (!mayDiscard()) return false;
    const auto remarks = workbench_.open(path);
    if (!remarks) {
        complain(tr("The file cannot be opened"), remarks.error());
        return false;
    }
    remember(path);
    tellOpened(QFileInfo(path).fileName(), *remarks);
    return true;
}

/// Each remark on a line of its own.
void FileCommands::tellOpened(const QString& name, const std::vector<Warning>& remarks) {
    if (remarks.empty()) return workbench_.tell(tr("Opened %1").arg(name));
    constexpr QLatin1Char lineEnd('\n');
    const QString opened = tr("Opened %1. Remarks (%2):").arg(name).arg(remarks.size());
    workbench_.tell(opened + lineEnd + remarksOf(remarks, lineEnd), true); // to stay until it is read
}

bool FileCommands::save() {
    return workbench_.path().isEmpty() ? saveAs() : saveTo(workbench_.path());
}

bool FileCommands::saveAs() {
    const QString path = fileToWrite(window_, tr("Save as"), QFileInfo(workbench_.path()).absolutePath(),
                                     tr("Toile documents (*.toile)"));
    return !path.isEmpty() && saveTo(path);
}

bool FileCommands::saveTo(const QString& path) {
    if (auto saved = workbench_.saveAs(path); !saved) {
        complain(tr("The file cannot be saved"), saved.error());
        return false;
    }
    remember(path);
    workbench_.tell(tr("Saved %1").arg(QFileInfo(path).fileName()));
    return true;
}

void FileCommands::exportDrape() {
    if (!workbench_.frame() || !writeDrape_)
        return workbench_.tell(tr("There is no drape to export yet: simulate first."), true);
    const QString file = fileToWrite(window_, tr("Export drape"), QFileInfo(workbench_.path()).absolutePath(),
                                     tr("glTF binary (*.glb);;Wavefront OBJ (*.obj);;PLY (*.ply);;STL (*.stl)"));
    if (file.isEmpty()) return;
    if (auto written = writeDrape_(file.toStdString(), *workbench_.frame()); !written)
        return complain(tr("The drape cannot be exported"), written.error());
    workbench_.tell(tr("Exported %1").arg(QFileInfo(file).fileName()));
}

void FileCommands::saveCheckpoint() {
    if (!workbench_.frame()) return workbench_.tell(tr("There is no simulation yet that could be saved."), true);
    const QFileInfo document(workbench_.path());
    const QString beside = document.absoluteDir().filePath(document.completeBaseName() + QStringLiteral(".checkpoint"));
    const QString file = fileToWrite(window_, tr("Save checkpoint"), workbench_.path().isEmpty() ? QString() : beside,
                                     tr("Toile checkpoints (*.checkpoint)"));
    if (!file.isEmpty()) workbench_.saveCheckpoint(file);
}

void FileCommands::resume() {
    const QString path =
        QFileDialog::getOpenFileName(&window_, tr("Resume"), QFileInfo(workbench_.path()).absolutePath(),
                                     tr("Toile checkpoints (*.checkpoint);;All files (*)"));
    if (!path.isEmpty()) resumeFrom(path);
}

void FileCommands::resumeFrom(const QString& checkpoint) {
    if (auto resumed = workbench_.resumeFrom(checkpoint); !resumed)
        complain(tr("The checkpoint cannot be resumed"), resumed.error());
}

void FileCommands::importAvatar() {
    const QString path =
        QFileDialog::getOpenFileName(&window_, tr("Import avatar"), QFileInfo(workbench_.path()).absolutePath(),
                                     tr("Bodies (*.glb *.gltf *.obj *.stl *.ply *.dae *.fbx);;All files (*)"));
    if (!path.isEmpty()) workbench_.importAvatar(path);
}

void FileCommands::moveAvatar() {
    MotionDialog dialog(&window_);
    if (dialog.exec() == QDialog::Accepted) workbench_.moveThroughPoses(dialog.folder(), dialog.step());
}

void FileCommands::useMannequin() {
    for (const QString& folder : sampleFolders_)
        if (const QString file = folder + QStringLiteral("/bodies/mannequin.glb"); QFileInfo::exists(file))
            return workbench_.importAvatar(file);
    workbench_.tell(tr("The mannequin is not installed."), true);
}

void FileCommands::openSample(const QString& path) {
    if (!mayDiscard()) return;
    if (auto opened = workbench_.openCopy(path); !opened)
        return complain(tr("The sample cannot be opened"), opened.error());
    workbench_.tell(tr("Opened the sample %1").arg(QFileInfo(path).completeBaseName()));
}

bool FileCommands::mayDiscard() {
    takeTyped(window_);
    if (!workbench_.isModified()) return true;
    QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), tr("The pattern has changes that are not saved."),
                    QMessageBox::NoButton, &window_);
    box.setObjectName(QStringLiteral("unsavedChanges"));
    box.setInformativeText(tr("Save them before going on?"));
    box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save: return save();
    case QMessageBox::Discard: return true; // the record goes with the work: what is to be opened may not be readable
    default: return false;
    }
}

bool FileCommands::offerRecovery() {
    Journal* journal = workbench_.journal();
    if (!journal) return false;
    for (const Journal::Leftover& leftover : journal->leftovers()) {
        const QString name =
            leftover.path.isEmpty() ? tr("a pattern that was never saved") : QFileInfo(leftover.path).fileName();
        QMessageBox box(QMessageBox::Question, tr("Recover unsaved work"),
                        tr("Toile ended without saving %1.").arg(name), QMessageBox::NoButton, &window_);
        box.setObjectName(QStringLiteral("recoverWork"));
        box.setInformativeText(tr("Recover it now, or discard it for good?"));
        QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
        QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
        box.addButton(tr("Later"), QMessageBox::RejectRole);
        box.exec();
        if (box.clickedButton() == static_cast<QAbstractButton*>(discard)) Journal::discard(leftover);
        if (box.clickedButton() != static_cast<QAbstractButton*>(recover)) continue;
        if (auto recovered = workbench_.recover(leftover); !recovered) {
            complain(tr("The work cannot be recovered"), recovered.error());
            continue;
        }
        return true; // more of them are offered at the next start
    }
    return false;
}

void FileCommands::fillRecent(QMenu& menu) {
    menu.clear();
    for (const QString& path : QSettings().value(recentKey).toStringList()) {
        QAction* action = menu.addAction(QFileInfo(path).fileName(), this, [this, path] { openFile(path); });
        action->setToolTip(path);
    }
    if (menu.isEmpty()) menu.addAction(tr("(none)"))->setEnabled(false);
}

QStringList FileCommands::samples() const {
    QStringList files;
    for (const QString& folder : sampleFolders_)
        for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.toile")}, QDir::Files, QDir::Name))
            files << file.absoluteFilePath();
    return files;
}

void FileCommands::fillSamples(QMenu& menu) {
    menu.clear();
    for (const QString& path : samples()) {
        QString name = QFileInfo(path).completeBaseName().replace(QLatin1Char('-'), QLatin1Char(' '));
        if (!name.isEmpty()) name[0] = name[0].toUpper();
        menu.addAction(name, this, [this, path] { openSample(path); });
    }
    if (menu.isEmpty()) menu.addAction(tr("(none installed)"))->setEnabled(false);
}

void FileCommands::remember(const QString& path) {
    QSettings settings;
    QStringList files = settings.value(recentKey).toStringList();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    settings.setValue(recentKey, QStringList(files.mid(0, recentFiles)));
}

void FileCommands::complain(const QString& title, const Error& error) {
    QMessageBox box(QMessageBox::Warning, title, title + QLatin1Char('.'), QMessageBox::Ok, &window_);
    box.setObjectName(QStringLiteral("fileProblem"));
    box.setInformativeText(QString::fromStdString(toString(error)));
    box.exec();
}

} // namespace toile::ui
