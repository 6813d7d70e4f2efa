// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Circumstances.h"
#include "core/study/GarmentAccuracy.h"
#include "ui/accuracy/TimeLeft.h"
#include "ui/workbench/Workbench.h"

#include <QElapsedTimer>
#include <QObject>

#include <atomic>
#include <list>
#include <thread>

namespace toile::ui {

/// What the study gets from outside: the study itself, the facts of build and machine, and how a report is written.
struct AccuracyParts {
    using Study = std::function<Result<study::GarmentAccuracy>(const std::string& name, const simulation::Scene& scene,
                                                               const study::GarmentPlan& plan, std::stop_token stop,
                                                               const Progress& progress)>;
    using Writer =
        std::function<Result<void>(const std::string& folder, const study::GarmentAccuracy& study,
                                   const std::optional<double>& within, const study::Circumstances& circumstances)>;
    Study study;
    std::function<study::Circumstances(std::string command)> circumstances; ///< takes a moment
    Writer write;
};

/// A finished study, with the garment it was made of.
struct StudiedGarment {
    study::GarmentAccuracy accuracy;
    study::Circumstances circumstances;
    simulation::Scene scene;
    std::vector<pattern::Pattern> meshes; ///< all that were tried, with the drawn one
};

/// The quick study of error against run time of the open garment (core/study/GarmentAccuracy.h), on a thread of its own
/// and of the garment as it is when it begins: editing goes on. What is cancelled ends by itself, unheard.
class AccuracyStudy : public QObject {
    Q_OBJECT
public:
    AccuracyStudy(Workbench& workbench, AccuracyParts parts, QObject* parent = nullptr);
    ~AccuracyStudy() override; ///< waits for what is under way to stop

    void start();
    void cancel();
    [[nodiscard]] bool isRunning() const { return static_cast<bool>(timeLeft_); }
    [[nodiscard]] double fraction() const { return fraction_; }
    [[nodiscard]] const std::string& doing() const { return doing_; } ///< in the words of the study
    [[nodiscard]] std::optional<double> secondsLeft() const;          ///< a guess [s]
    [[nodiscard]] const QString& problem() const { return problem_; } ///< why the last one has no result; or empty

    [[nodiscard]] const std::optional<StudiedGarment>& result() const { return result_; }
    [[nodiscard]] int resultNumber() const { return resultNumber_; } ///< rises with every result
    /// The garment was edited since, beyond its spacings as they were tried.
    [[nodiscard]] bool isStale() const;
    /// The open document with the mesh of this run; absent where it has that already. Only while it is not stale.
    [[nodiscard]] std::optional<document::Document> withMeshOf(const study::GarmentRun& run) const;

    /// The report in Markdown, as the command line writes it.
    [[nodiscard]] QString text(const std::optional<double>& within) const;
    void save(const QString& folder, const std::optional<double>& within);

Q_SIGNALS:
    void changed(); ///< state, result, or the document
    void progressed();
    void saved(const QString& folder);
    void notSaved(const QString& why);

private:
    struct Work {
        std::atomic<bool> over{false};
        std::jthread thread;
    };

    void onThread(std::function<void()> work);
    void dropOver();
    void begin(double fraction, const std::string& what);
    void finish(Result<StudiedGarment> result);
    [[nodiscard]] std::string command() const;

    Workbench& workbench_;
    AccuracyParts parts_;
    std::list<Work> works_; ///< threads that were not seen to have ended
    std::stop_source stop_; ///< of the study under way
    int number_ = 0;        ///< of the study under way: words of earlier ones are not heard
    QElapsedTimer clock_;
    std::optional<TimeLeft> timeLeft_; ///< absent while nothing runs
    double fraction_ = 0;
    std::string doing_;
    QString problem_;
    std::optional<StudiedGarment> result_;
    int resultNumber_ = 0;
};

} // namespace toile::ui
