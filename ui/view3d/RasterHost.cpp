// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/SceneHost.h"

#include "core/picture/OffscreenGl.h"

#include <QImage>
#include <QPainter>
#include <QTimer>
#include <QWidget>

#include <optional>

namespace toile::ui {

namespace {

class RasterCanvas : public QWidget {
public:
    RasterCanvas(ShownNow shown, HostFailed failed, QWidget* parent)
        : QWidget(parent), shown_(std::move(shown)), failed_(std::move(failed)) {
        setObjectName("view3dRasterHost");
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_OpaquePaintEvent);
    }

    void changed() {
        picture_ = {};
        update();
    }
    [[nodiscard]] QString deviceName() const { return gl_ ? QString::fromStdString(gl_->deviceName()) : QString(); }

protected:
    void paintEvent(QPaintEvent*) override {
        const QSize size = this->size() * devicePixelRatioF();
        if (picture_.size() != size) draw(size);
        QPainter painter(this);
        if (picture_.isNull()) painter.fillRect(rect(), palette().mid());
        else painter.drawImage(rect(), picture_);
    }

private:
    void draw(QSize size) {
        if (broken_ || size.isEmpty()) return;
        if (!gl_) {
            auto gl = picture::OffscreenGl::create();
            if (!gl) return fail(gl.error());
            gl_.emplace(std::move(*gl));
        }
        const Shown now = shown_();
        const auto image = gl_->render(now.scene, now.camera, {size.width(), size.height()}, devicePixelRatioF());
        if (!image) return fail(image.error());
        picture_ = QImage(image->rgba.data(), image->width, image->height, QImage::Format_RGBA8888)
                       .convertToFormat(QImage::Format_RGB32); // copies
    }
    void fail(const Error& error) {
        broken_ = true;
        QTimer::singleShot(0, this, [this, why = QString::fromStdString(error.text)] { failed_(why); });
    }

    ShownNow shown_;
    HostFailed failed_;
    std::optional<picture::OffscreenGl> gl_;
    QImage picture_;
    bool broken_ = false;
};

class RasterHost : public SceneHost {
public:
    RasterHost(ShownNow shown, HostFailed failed, QWidget* parent)
        : canvas_(new RasterCanvas(std::move(shown), std::move(failed), parent)) {}
    [[nodiscard]] QWidget* widget() override { return canvas_; }
    void changed() override { canvas_->changed(); }
    [[nodiscard]] QString deviceName() const override { return canvas_->deviceName(); }

private:
    RasterCanvas* canvas_;
};

} // namespace

std::unique_ptr<SceneHost> makeRasterHost(ShownNow shown, HostFailed failed, QWidget* parent) {
    return std::make_unique<RasterHost>(std::move(shown), std::move(failed), parent);
}

} // namespace toile::ui
