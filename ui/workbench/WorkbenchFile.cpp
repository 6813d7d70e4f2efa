// SPDX-License-Identifier: GPL-3.0-or-later
// The document's file: opening, saving, recovering.
#include "ui/workbench/AvatarPath.h"
#include "ui/workbench/Workbench.h"

#include <QFileInfo>

namespace toile::ui {

void Workbench::startNew() {
    document::Document empty;
    material::Fabric fabric;
    fabric.id = material::FabricId("f1");
    fabric.name = tr("Cotton").toStdString();
    fabric.source = tr("Values of the order of a cotton poplin, not measured.").toStdString();
    empty.pattern.fabrics.push_back(Shared<material::Fabric>(std::move(fabric)));
    empty.nextId = 2;
    startFrom(std::move(empty), {}, false);
}

Result<void> Workbench::open(const QString& path) {
    auto read = parts_.read(path.toStdString());
    if (!read) return tl::unexpected(read.error());
    const bool ours = path.endsWith(QLatin1String(".toile"), Qt::CaseInsensitive);
    startFrom(std::move(*read), ours ? QFileInfo(path).absoluteFilePath() : QString(), !ours);
    return {};
}

void Workbench::startFrom(document::Document document, const QString& path, bool modified) {
    path_ = path;
    history_ = modified ? document::History::unsaved(std::move(document)) : document::History(std::move(document));
    if (journal_) journal_->clear();
    recovery_.stop();
    pause();
    resumeWhenReady_.reset();
    scene_.reset();
    resetNext_ = true;
    selection_.clear();
    frame_.reset();
    documentMoved();
    Q_EMIT selectionChanged();
    Q_EMIT fileChanged();
    Q_EMIT frameArrived(); // there is none: the old garment goes from the view
    Q_EMIT documentReplaced();
}

Result<void> Workbench::openCopy(const QString& path) {
    auto read = parts_.read(path.toStdString());
    if (!read) return tl::unexpected(read.error());
    read->avatarFile = avatarPath(read->avatarFile, QFileInfo(path).absoluteFilePath()).toStdString();
    startFrom(std::move(*read), {}, false);
    return {};
}

Result<void> Workbench::recover(const Journal::Leftover& leftover) {
    auto read = parts_.read(leftover.file.toStdString());
    if (!read) return tl::unexpected(read.error());
    startFrom(std::move(*read), leftover.path, true);
    record(); // under our own name, before the other one goes
    Journal::discard(leftover);
    return {};
}

Result<void> Workbench::saveAs(const QString& path) {
    document::Document toWrite = document();
    if (!toWrite.avatarFile.empty()) // the same body, named from the new place
        toWrite.avatarFile = avatarName(avatarPath(toWrite.avatarFile, path_), path);
    if (auto written = parts_.write(path.toStdString(), toWrite); !written) return written;
    path_ = QFileInfo(path).absoluteFilePath();
    if (!(toWrite == document())) history_.push(tr("Save as").toStdString(), std::move(toWrite));
    history_.markSaved();
    if (journal_) journal_->clear();
    recovery_.stop();
    Q_EMIT fileChanged();
    return {};
}

void Workbench::record() {
    if (!journal_ || !isModified()) return;
    if (auto written = journal_->record(document(), path_); !written)
        tell(QString::fromStdString(toString(written.error())), true);
}

} // namespace toile::ui
