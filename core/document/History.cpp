// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/History.h"

#include <utility>

namespace toile::document {

History::History(Document document, HistorySettings settings)
    : values_{{std::string(), document}}, saved_(std::move(document)), settings_(settings) {}

History History::unsaved(Document document, HistorySettings settings) {
    History history(std::move(document), settings);
    history.saved_.reset();
    return history;
}

void History::push(std::string name, Document next, const std::string& mergeKey) {
    if (next == current()) return;
    values_.resize(at_ + 1);
    if (!mergeKey.empty() && mergeKey == mergeKey_ && at_ > 0) {
        values_[at_].document = std::move(next);
        return;
    }
    values_.push_back({std::move(name), std::move(next)});
    if (values_.size() > settings_.steps + 1) values_.erase(values_.begin());
    at_ = values_.size() - 1;
    mergeKey_ = mergeKey;
}

void History::undo() {
    if (canUndo()) --at_;
    endMerge();
}

void History::redo() {
    if (canRedo()) ++at_;
    endMerge();
}

} // namespace toile::document
