// SPDX-License-Identifier: GPL-3.0-or-later
// The document's file: opening, saving, recovering.
#include "core/io/DocumentFile.h"
#include "ui/workbench/Workbench.h"

#include <QFileInfo>

namespace toile::ui {
namespace {

/// Where the avatar lies that a document of this path names. While a document is open it names its avatar so, in every
/// step of its history: wherever it is saved, undo finds the same body.
std::string avatarFrom(const QString& path, const std::string& name) {
    if (name.empty() || path.isEmpty()) return name;
    return io::fileNamedBy(path.toStdString(), name).lexically_normal().generic_string();
}

} // namespace

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

Result<std::vector<Warning>> Workbench::open(const QString& path) {
    const QString file = QFileInfo(path).absoluteFilePath();
    auto read = readAs(file, file);
    if (!read) return tl::unexpected(read.error());
    const bool ours = path.endsWith(QLatin1String(".toile"), Qt::CaseInsensitive);
    startFrom(std::move(read->document), ours ? file : QString(), !ours);
    return std::move(read->warnings);
}

/// A document that belongs at `path`; its avatar is named from everywhere.
Result<io::Imported> Workbench::readAs(const QString& path, const QString& file) const {
    auto read = parts_.read(file.toStdString());
    if (read) read->document.avatarFile = avatarFrom(path, read->document.avatarFile);
    return read;
}

void Workbench::startFrom(document::Document document, const QString& path, bool modified) {
    path_ = path;
    history_ = modified ? document::History::unsaved(std::move(document)) : document::History(std::move(document));
    if (journal_) journal_->clear();
    recovery_.stop();
    pause();
    resumeWhenReady_.reset();
    scene_.reset();
    bodyFile_.reset();
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
    const QString file = QFileInfo(path).absoluteFilePath();
    auto read = readAs(file, file);
    if (!read) return tl::unexpected(read.error());
    startFrom(std::move(read->document), {}, false);
    return {};
}

Result<void> Workbench::recover(const Journal::Leftover& leftover) {
    auto read = readAs(leftover.path, leftover.file);
    if (!read) return tl::unexpected(read.error());
    startFrom(std::move(read->document), leftover.path, true);
    if (!journal_) return {};
    // Under our own name, before the other one goes: until then that is the only copy.
    if (auto recorded = record(); recorded) Journal::discard(leftover);
    else tell(QString::fromStdString(toString(recorded.error())), true);
    return {};
}

Result<void> Workbench::saveAs(const QString& path) {
    document::Document toWrite = document();
    std::string& avatar = toWrite.avatarFile;
    if (!avatar.empty()) avatar = io::nameFrom(path.toStdString(), avatar);
    if (auto written = parts_.write(path.toStdString(), toWrite); !written) return written;
    path_ = QFileInfo(path).absoluteFilePath();
    history_.markSaved();
    if (journal_) journal_->clear();
    recovery_.stop();
    Q_EMIT fileChanged();
    return {};
}

/// Edits that follow do not put it off: who never pauses is recorded as well.
void Workbench::recordSoon() {
    if (journal_ && !recovery_.isActive()) recovery_.start();
}

Result<void> Workbench::record() {
    if (!journal_) return {};
    if (isModified()) return journal_->record(document(), path_);
    journal_->clear(); // undone: what was recorded before is not wanted back
    return {};
}

} // namespace toile::ui
