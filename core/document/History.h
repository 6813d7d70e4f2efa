// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/Document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace toile::document {

struct HistorySettings {
    std::size_t steps = 1000; ///< kept for undo [–]; values share what they have in common, so a step is small
};

/// The document with its past and future values: undo is the value we had before.
class History {
public:
    /// Begins with a document as it lies in its file, or with an empty one.
    explicit History(Document document = {}, HistorySettings settings = {});
    /// Begins with a document that lies in no file as it is: modified until it is saved, with nothing before it.
    [[nodiscard]] static History unsaved(Document document, HistorySettings settings = {});

    [[nodiscard]] const Document& current() const { return values_[at_].document; }

    /// Goes on with a new value; a future that was undone is forgotten. A value equal to the current one is no step.
    /// Steps pushed in a row with the same merge key that is not empty (a drag) are one step.
    void push(std::string name, Document next, const std::string& mergeKey = {});
    /// The next push begins a step of its own, whatever its key: the drag has ended.
    void endMerge() { mergeKey_.clear(); }

    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ + 1 < values_.size(); }
    /// Name of the step that would be undone or redone, for menus; empty if there is none.
    [[nodiscard]] std::string undoName() const { return canUndo() ? values_[at_].name : std::string(); }
    [[nodiscard]] std::string redoName() const { return canRedo() ? values_[at_ + 1].name : std::string(); }
    void undo(); ///< without a past: nothing
    void redo(); ///< without a future: nothing

    /// The current value is the one on disk.
    void markSaved() {
        saved_ = current();
        endMerge();
    }
    /// The current value differs from the one last saved, or the one it began with.
    [[nodiscard]] bool isModified() const { return !saved_ || !(current() == *saved_); }

private:
    struct Step {
        std::string name; ///< of the edit that led here
        Document document;
    };
    std::vector<Step> values_;
    std::size_t at_ = 0;
    std::optional<Document> saved_; ///< absent = no value is
    std::string mergeKey_;
    HistorySettings settings_;
};

} // namespace toile::document
