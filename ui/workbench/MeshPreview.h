// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/pattern/Pattern.h"
#include "ui/pattern/MeshLines.h"

#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace toile::ui {

/// What the preview found out about a pattern.
struct MeshedPattern {
    std::uint64_t generation = 0; ///< as given with the pattern
    MeshLines lines;
    meshing::MeshReport report;
};

/// Meshes patterns on a thread of its own. The newest pattern wins: one that was handed over while another was being
/// meshed waits, and is replaced by any that comes later.
class MeshPreview : public QObject {
    Q_OBJECT
public:
    /// The mesh stands until the next call; only the preview's thread calls.
    using Mesher = std::function<Result<const meshing::GarmentMesh*>(const pattern::Pattern&)>;

    explicit MeshPreview(Mesher mesher, QObject* parent = nullptr);
    ~MeshPreview() override; ///< waits for the pattern being meshed

    /// Never waits.
    void request(pattern::Pattern pattern, std::uint64_t generation);

Q_SIGNALS:
    void meshed(const toile::ui::MeshedPattern& result);
    void failed(quint64 generation, const QString& why);

private:
    struct Request {
        pattern::Pattern pattern;
        std::uint64_t generation = 0;
    };
    void work(std::stop_token stop);
    void answer(const Request& request);

    Mesher mesher_;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Request> waiting_;
    std::jthread thread_; // last: starts when everything else is there
};

} // namespace toile::ui
