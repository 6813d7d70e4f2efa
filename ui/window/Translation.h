// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QLocale>
#include <QTranslator>

#include <memory>

namespace toile::ui {

/// The program's texts in another language, from a table { "English text": "translated" } in
/// resources/translations, named by the locale. The English text is the key, whatever its context; what the
/// table does not have stays English.
class Translation : public QTranslator {
public:
    /// Null where there is no table for the locale.
    [[nodiscard]] static std::unique_ptr<Translation> of(const QLocale& locale);

    [[nodiscard]] QString translate(const char* context, const char* sourceText, const char* disambiguation = nullptr,
                                    int n = -1) const override;
    [[nodiscard]] bool isEmpty() const override { return table_.isEmpty(); }
    [[nodiscard]] const QHash<QString, QString>& table() const { return table_; }

private:
    QHash<QString, QString> table_;
};

} // namespace toile::ui
