// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"

#include <QLockFile>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace toile::ui {

/// Documents that were being edited when a program ended without saving.
///
/// Each running program keeps one file NAME.recovery.toile in the folder, beside it NAME.recovery.txt with the path of
/// the document it belongs to (empty for one never saved), and holds the lock NAME.recovery.lock.
class Journal {
public:
    using Write = std::function<Result<void>(const std::string& file, const document::Document&)>;

    Journal(QString folder, Write write);

    /// Replaces what was written before.
    [[nodiscard]] Result<void> record(const document::Document& document, const QString& path);
    /// The work is saved, or was given up: nothing to recover.
    void clear();

    struct Leftover {
        QString file; ///< holds the document
        QString path; ///< where it was last saved; empty = never
    };
    /// What programs that no longer run have left.
    [[nodiscard]] std::vector<Leftover> leftovers() const;
    static void discard(const Leftover& leftover);

private:
    QString folder_, name_;
    Write write_;
    std::unique_ptr<QLockFile> lock_; ///< held while there is something to recover
};

} // namespace toile::ui
