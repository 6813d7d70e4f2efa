// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/Journal.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QUuid>

namespace toile::ui {
namespace {

const QString documentEnding = QStringLiteral(".recovery.toile");
const QString noteEnding = QStringLiteral(".recovery.txt");

const QString lockEnding = QStringLiteral(".recovery.lock");

QString beside(const QString& document, const QString& ending) {
    return document.chopped(documentEnding.size()) + ending;
}

/// Nobody who still runs holds the lock.
bool isAbandoned(const QString& document) {
    QLockFile lock(beside(document, lockEnding));
    lock.setStaleLockTime(0); // old locks of a running program count as well
    return lock.tryLock(0);
}

} // namespace

Journal::Journal(QString folder, Write write)
    : folder_(std::move(folder)), name_(QUuid::createUuid().toString(QUuid::WithoutBraces)), write_(std::move(write)) {}

Result<void> Journal::record(const document::Document& document, const QString& path) {
    QDir().mkpath(folder_);
    const QDir folder(folder_);
    if (!lock_) {
        lock_ = std::make_unique<QLockFile>(folder.filePath(name_ + lockEnding));
        lock_->setStaleLockTime(0);
        lock_->tryLock(0); // the name is ours alone; without the lock another program may offer our work as lost
    }
    if (auto written = write_(folder.filePath(name_ + documentEnding).toStdString(), document); !written)
        return written;
    QSaveFile note(folder.filePath(name_ + noteEnding));
    const bool noted = note.open(QIODevice::WriteOnly) && note.write(path.toUtf8() + '\n') >= 0 && note.commit();
    if (noted) return {};
    return fail(ErrorCode::io, "The recovery note could not be written.", {.file = note.fileName().toStdString()});
}

void Journal::clear() {
    const QDir folder(folder_);
    discard({folder.filePath(name_ + documentEnding), {}});
    lock_.reset();
}

std::vector<Journal::Leftover> Journal::leftovers() const {
    std::vector<Leftover> found;
    const QDir folder(folder_);
    for (const QString& name : folder.entryList({QLatin1Char('*') + documentEnding}, QDir::Files, QDir::Time)) {
        const QString file = folder.filePath(name);
        if (!isAbandoned(file)) continue;
        QFile note(beside(file, noteEnding));
        const bool noted = note.open(QIODevice::ReadOnly);
        found.push_back({file, noted ? QString::fromUtf8(note.readLine().trimmed()) : QString()});
    }
    return found;
}

void Journal::discard(const Leftover& leftover) {
    QFile::remove(leftover.file);
    QFile::remove(beside(leftover.file, noteEnding));
}

} // namespace toile::ui
