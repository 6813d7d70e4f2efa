// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/Remarks.h"

#include <QStringList>

namespace toile::ui {

QString remarksOf(const std::vector<Warning>& warnings, QChar between) {
    QStringList remarks;
    for (const Warning& warning : warnings) remarks << QString::fromStdString(warning.place + ": " + warning.text);
    return remarks.join(between);
}

} // namespace toile::ui
