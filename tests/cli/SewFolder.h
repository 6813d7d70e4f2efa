// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Program.h"
#include "core/io/BodyImport.h"
#include "core/io/ToileFile.h"
#include "samples/SmallScenes.h"

#include <QTemporaryDir>
#include <memory>

namespace toile {

/// An upright box with its foot on the floor and its middle on the y axis.
inline body::Body box(double width, double depth) {
    body::Body body{"box", {}, {}, {}};
    for (const double x : {-width / 2, width / 2})
        for (const double y : {0.0, 2.0})
            for (const double z : {-depth / 2, depth / 2}) body.mesh.vertices.push_back({x, y, z});
    body.mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                           {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    return body;
}

/// Where runs of `toile-cli sew` leave what they write: a folder for each test.
class SewFolder {
protected:
    [[nodiscard]] bool makeAnew() {
        folder_ = std::make_unique<QTemporaryDir>();
        return folder_->isValid();
    }
    [[nodiscard]] QString in(const char* name) const { return folder_->filePath(name); }
    [[nodiscard]] Json report() const { return jsonOf(contentOf(in("sew.json"))); }
    /// A document of two squares that are 0.2 m apart, with a body between them.
    [[nodiscard]] QString squaresWith(const body::Body& body) const {
        document::Document document = samples::twoSquares();
        document.avatarFile = "body.glb";
        document.scene.damping = 2; // so that it comes to rest against the body
        const bool written = io::writeBody(in("body.glb").toStdString(), body).has_value() &&
                             io::writeToile(document, in("squares.toile").toStdString()).has_value();
        return written ? in("squares.toile") : QString();
    }
    /// All that is there, also what is hidden.
    [[nodiscard]] QStringList files() const {
        return QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

} // namespace toile
