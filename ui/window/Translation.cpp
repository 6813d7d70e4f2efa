// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Translation.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

namespace toile::ui {

std::unique_ptr<Translation> Translation::of(const QLocale& locale) {
    QFile file(QStringLiteral(":/translations/%1.json").arg(locale.name()));
    if (!file.open(QIODevice::ReadOnly)) return nullptr;
    auto translation = std::make_unique<Translation>();
    const QJsonObject pairs = QJsonDocument::fromJson(file.readAll()).object();
    for (auto pair = pairs.begin(); pair != pairs.end(); ++pair)
        translation->table_.insert(pair.key(), pair.value().toString());
    return translation;
}

QString Translation::translate(const char*, const char* sourceText, const char*, int) const {
    return table_.value(QString::fromUtf8(sourceText));
}

} // namespace toile::ui
