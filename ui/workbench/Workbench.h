// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/History.h"
#include "core/io/DocumentFile.h"
#include "ui/tools/Tool.h"
#include "ui/workbench/Journal.h"
#include "ui/workbench/MeshPreview.h"
#include "ui/workbench/Simulation.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace toile::ui {

/// What the workbench gets from outside: files, meshes, a simulation.
struct WorkbenchParts {
    std::function<Result<io::Imported>(const std::string& file)> read;
    std::function<Result<void>(const std::string& file, const document::Document&)> write;
    std::function<Result<body::Body>(const std::string& file)> readBody;
    /// A folder of poses of this body, so far apart in time [s].
    std::function<Result<geometry::VertexMotion>(const std::string& folder, const body::Body&, double step)> readMotion;
    std::function<Result<simulation::Checkpoint>(const std::string& file)> readCheckpoint;
    std::function<Result<void>(const std::string& file, const simulation::Checkpoint&)> writeCheckpoint;
    MeshPreview::Mesher mesh;
    std::unique_ptr<Simulation> simulation;
    QString recoveryFolder;                        ///< empty = no crash journal
    std::chrono::milliseconds recoveryDelay{3000}; ///< from an edit to its record
};

/// The document with its history and file, and what follows from it: the flat drawing, the mesh preview, the running
/// simulation. Everything the window shows is asked here; everything it does ends here.
class Workbench : public QObject {
    Q_OBJECT
public:
    explicit Workbench(WorkbenchParts parts, QObject* parent = nullptr);
    ~Workbench() override;

    /// The path of its avatar is absolute while it is open.
    [[nodiscard]] const document::Document& document() const { return history_.current(); }
    [[nodiscard]] const document::History& history() const { return history_; }
    [[nodiscard]] const FlatPattern& flat() const { return flat_; }
    [[nodiscard]] const Selection& selection() const { return selection_; }
    [[nodiscard]] Desk desk() const { return {document(), flat_, selection_}; }
    [[nodiscard]] const MeshLines& mesh() const { return meshed_.lines; }
    [[nodiscard]] const meshing::MeshReport& meshReport() const { return meshed_.report; }
    [[nodiscard]] const std::optional<simulation::Frame>& frame() const { return frame_; }
    [[nodiscard]] const std::optional<Shared<body::Body>>& body() const { return body_; }
    /// What is handed over to the simulation; absent before the first. Not the document's while its body is being read.
    [[nodiscard]] const std::optional<simulation::Scene>& scene() const { return scene_; }
    [[nodiscard]] bool isReadingBody() const { return bodyLoading_; }
    /// Counts the scenes that were handed over: frames of older ones are not shown.
    [[nodiscard]] std::uint64_t generation() const { return generation_; }

    void take(const Effect& effect);
    void apply(const Edit& edit);
    void select(const Selection& selection);
    void undo();
    void redo();

    [[nodiscard]] const QString& path() const { return path_; }
    [[nodiscard]] bool isModified() const { return history_.isModified(); }
    void startNew(); ///< an empty pattern with one fabric
    /// What the file did not say, or not as it is now, is given back.
    [[nodiscard]] Result<std::vector<Warning>> open(const QString& path);
    /// Begins with a value: a sample, an import, a recovered document. A modified one has never been saved as it is.
    void startFrom(document::Document document, const QString& path, bool modified);
    /// A document from a place that is not to be written: a sample. It has no path of its own.
    [[nodiscard]] Result<void> openCopy(const QString& path);
    /// Goes on with the unsaved work of a program that ended by accident.
    [[nodiscard]] Result<void> recover(const Journal::Leftover& leftover);
    [[nodiscard]] Result<void> saveAs(const QString& path);
    /// The body of the file becomes the document's avatar: one undoable step. It is read although it is the avatar
    /// already: the file may be another one by now.
    void importAvatar(const QString& path);
    void removeAvatar();
    [[nodiscard]] Journal* journal() { return journal_ ? &*journal_ : nullptr; }

    [[nodiscard]] bool isPlaying() const { return parts_.simulation && parts_.simulation->isPlaying(); }
    void play();
    void pause();
    void step();
    void reset();
    /// From now on a garment that comes to rest is finished by statics, or not any more.
    void finishAtRest(bool wanted);
    /// By which method a sewn garment is draped from now on.
    void drapeWith(dynamics::Method method);
    [[nodiscard]] dynamics::Method method() const { return method_; }
    /// Why another method cannot take over now; empty = it can.
    [[nodiscard]] QString whyMethodStays() const;
    /// What hands hold from now on; what plays follows them.
    void hold(std::vector<simulation::Grip> grips);
    /// The avatar's arms go up by 60°, or back down, while the garment plays; what cannot be is told.
    void liftArms();
    /// The avatar goes through the poses in a folder, so far apart in time [s], once they are read; what cannot be is
    /// told.
    void moveThroughPoses(const QString& folder, double step);
    /// The way the avatar moved last, backwards; what cannot be is told.
    void moveBack();
    [[nodiscard]] bool bodyHasMoved() const { return frame_ && frame_->body; }
    [[nodiscard]] bool armsAreUp() const { return bodyHasMoved() && movesArms_; }
    /// Why the avatar cannot leave the pose that the document has it in; empty = it can.
    [[nodiscard]] QString whyNotMoved() const;
    [[nodiscard]] QString whyNotMovedBack() const;
    /// Writes where the simulation stands, once the frame step under way is done.
    void saveCheckpoint(const QString& path);
    /// The garment goes on from there, paused: now, or when its body has been read.
    [[nodiscard]] Result<void> resumeFrom(const QString& path);
    /// Asks for a new frame; called by a timer 60 times a second while the simulation has something to do.
    void pollFrame();
    [[nodiscard]] bool isFollowing() const { return frames_.isActive(); }

    void tell(const QString& message, bool isProblem = false);

Q_SIGNALS:
    void documentChanged();
    void documentReplaced(); ///< by another one: opened, new, recovered
    void selectionChanged();
    void meshChanged();
    void bodyChanged();
    void frameArrived();
    void posesRead(); ///< or not any more being read
    void playingChanged();
    void fileChanged(); ///< path or modified mark
    void messageChanged(const QString& message, bool isProblem);

private:
    /// Who has a problem with the pattern as it is, if that was told last.
    enum class Complaint { none, ofMesh, ofSimulation };

    [[nodiscard]] Result<io::Imported> readAs(const QString& path, const QString& file) const;
    void documentMoved();
    void loadBody();
    void takeBody(std::uint64_t reading, Result<body::Body> body);
    void takeCheckpoint();
    [[nodiscard]] QString whyAvatarStays() const;
    void move(geometry::VertexMotion motion, bool liftsArms);
    void takeMotion(const Shared<body::Body>& body, Result<geometry::VertexMotion> motion);
    void tellOfFinish(const simulation::Frame& frame);
    void tellOfProblem(const QString& why);
    void takeBack(Complaint complaint);
    void follow();   ///< what was ordered
    void handOver(); ///< document → mesh preview and simulation
    void recordSoon();
    [[nodiscard]] Result<void> record();

    WorkbenchParts parts_;
    document::History history_;
    FlatPattern flat_;
    Selection selection_;
    QString path_;
    MeshPreview preview_;
    MeshedPattern meshed_;
    std::optional<simulation::Frame> frame_;
    std::optional<Shared<body::Body>> body_;
    std::optional<QString>
        bodyFile_;                  ///< path that body_ was read from, or is being read from; absent = to be read anew
    std::uint64_t bodyReading_ = 0; ///< counts the readings: what an older one gives is dropped
    bool bodyLoading_ = false;      ///< the simulation waits for it
    bool playWhenReady_ = false;
    std::optional<simulation::Checkpoint> resumeWhenReady_;
    QString checkpointPath_;                        ///< where the checkpoint that was asked for goes
    bool resetNext_ = false;                        ///< the next scene begins anew
    std::uint64_t generation_ = 0;                  ///< of scene_
    std::uint64_t patternGeneration_ = 0;           ///< of meshedPattern_
    std::optional<pattern::Pattern> meshedPattern_; ///< handed to the mesh preview
    std::optional<simulation::Scene> scene_;        ///< handed to the simulation
    bool wasPlaying_ = false;
    dynamics::Method method_ = dynamics::Method::xpbd;
    std::shared_ptr<const geometry::VertexMotion> motion_; ///< ordered last, away from the first pose
    bool movesArms_ = false;                               ///< it lifts them
    bool motionLoading_ = false;                           ///< another one is being read
    Complaint complaint_ = Complaint::none;                ///< that the message told last is
    std::optional<Journal> journal_;
    QTimer frames_, recovery_;
    std::jthread bodyThread_;   ///< reads a body; the next one waits for it
    std::jthread motionThread_; ///< reads poses, of one motion at a time
};

} // namespace toile::ui
