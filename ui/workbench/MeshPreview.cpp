// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/MeshPreview.h"

#include <utility>

namespace toile::ui {

MeshPreview::MeshPreview(Mesher mesher, QObject* parent)
    : QObject(parent), mesher_(std::move(mesher)), thread_([this](std::stop_token stop) { work(stop); }) {}

MeshPreview::~MeshPreview() {
    thread_.request_stop();
    thread_.join();
}

void MeshPreview::request(pattern::Pattern pattern, std::uint64_t generation) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = Request{std::move(pattern), generation};
    }
    wake_.notify_one();
}

void MeshPreview::work(std::stop_token stop) {
    while (true) {
        Request request;
        {
            std::unique_lock lock(mutex_);
            if (!wake_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            request = std::move(*waiting_);
            waiting_.reset();
        }
        answer(request);
    }
}

void MeshPreview::answer(const Request& request) {
    const auto mesh = mesher_(request.pattern);
    if (!mesh) {
        const QString why = QString::fromStdString(toString(mesh.error()));
        QMetaObject::invokeMethod(this,
                                  [this, generation = request.generation, why] { Q_EMIT failed(generation, why); });
        return;
    }
    MeshedPattern result{request.generation, meshLinesOf(**mesh), (*mesh)->report};
    QMetaObject::invokeMethod(this, [this, result = std::move(result)] { Q_EMIT meshed(result); });
}

} // namespace toile::ui
