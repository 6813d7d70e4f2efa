// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/Workbench.h"

#include <QStringList>

class QMenu;
class QWidget;

namespace toile::ui {

/// What the window can do with files, with its dialogs. Every way to lose work asks first.
class FileCommands : public QObject {
    Q_OBJECT
public:
    /// Writes the draped garment; absent where the build cannot.
    using DrapeWriter = std::function<Result<void>(const std::string& file, const simulation::Frame&)>;

    FileCommands(Workbench& workbench, QWidget& window, DrapeWriter writeDrape, QStringList sampleFolders);

    void startNew();
    void open();
    bool openFile(const QString& path); ///< asks about unsaved changes, tells what goes wrong
    bool save();
    bool saveAs();
    void exportDrape();
    void saveCheckpoint();
    void resume();
    void resumeFrom(const QString& checkpoint); ///< tells what goes wrong
    void importAvatar();
    void moveAvatar();   ///< through poses
    void useMannequin(); ///< the body that comes with the samples
    void openSample(const QString& path);
    /// Asks what to do with unsaved changes; false = stay.
    [[nodiscard]] bool mayDiscard();
    /// Offers what a program that ended by accident has left; true when the user goes on with it.
    bool offerRecovery();

    void fillRecent(QMenu& menu);
    void fillSamples(QMenu& menu);
    /// .toile files of the sample folders, by name.
    [[nodiscard]] QStringList samples() const;

private:
    bool saveTo(const QString& path);
    void tellOpened(const QString& name, const std::vector<Warning>& remarks);
    void remember(const QString& path);
    void complain(const QString& title, const Error& error);

    Workbench& workbench_;
    QWidget& window_;
    DrapeWriter writeDrape_;
    QStringList sampleFolders_;
};

} // namespace toile::ui
