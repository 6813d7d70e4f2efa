// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/AvatarPath.h"

#include <QDir>
#include <QFileInfo>

namespace toile::ui {

QString avatarPath(const std::string& avatar, const QString& documentPath) {
    const QString file = QString::fromStdString(avatar);
    if (file.isEmpty() || QDir::isAbsolutePath(file) || documentPath.isEmpty()) return file;
    return QDir::cleanPath(QFileInfo(documentPath).absoluteDir().filePath(file));
}

std::string avatarName(const std::string& avatar, const QString& documentPath) {
    if (avatar.empty()) return {};
    return QFileInfo(documentPath).absoluteDir().relativeFilePath(QString::fromStdString(avatar)).toStdString();
}

} // namespace toile::ui
