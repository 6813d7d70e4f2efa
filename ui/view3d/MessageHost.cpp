// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/SceneHost.h"

#include <QLabel>

namespace toile::ui {

namespace {

class MessageHost : public SceneHost {
public:
    MessageHost(const QString& why, QWidget* parent) : label_(new QLabel(why, parent)) {
        label_->setObjectName("view3dMessage");
        label_->setAlignment(Qt::AlignCenter);
        label_->setWordWrap(true);
        label_->setMargin(24);
    }
    [[nodiscard]] QWidget* widget() override { return label_; }
    void changed() override {}
    [[nodiscard]] QString deviceName() const override { return {}; }

private:
    QLabel* label_;
};

} // namespace

std::unique_ptr<SceneHost> makeMessageHost(const QString& why, QWidget* parent) {
    return std::make_unique<MessageHost>(why, parent);
}

} // namespace toile::ui
