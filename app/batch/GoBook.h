// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/RecordBook.h"
#include "core/document/Document.h"
#include "core/simulation/Scene.h"

#include <functional>
#include <optional>
#include <string>

namespace toile::batch {

/// What the drapes of a document follow from: its text and its body.
[[nodiscard]] std::string hashOf(const document::Document& document, const simulation::Scene& scene);

/// Keeps every drape of a document's study as it comes, so that a study that was stopped goes on with the next one.
/// The keeper of studyGarment() and studyRegions().
template <class Go>
struct GoBook {
    RecordBook& book;
    std::string hash; ///< hashOf()
    const study::Circumstances& circumstances;
    const char* schema;
    std::optional<Go> (*readBack)(const Json&);

    Result<Go> operator()(Json key, const std::function<Result<Go>()>& run) const {
        Json scene = *key.find("scene");
        key.set("scene", scene.set("hash", hash));
        const auto recordsOf = [&](const Go& go) {
            Json record;
            study::note(record, schema, circumstances);
            record.set("scene", *key.find("scene")).set("method", *key.find("method")).set("go", toJson(go));
            return std::vector{std::move(record)};
        };
        const auto from = [&](const std::vector<Json>& known) {
            const Json* kept = known.front().find("go");
            auto go = kept ? readBack(*kept) : std::nullopt;
            return go ? Result<Go>(std::move(*go)) : run();
        };
        return book.part({key}, 1, from, run, recordsOf);
    }
};

} // namespace toile::batch
