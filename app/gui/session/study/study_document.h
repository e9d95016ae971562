#pragma once

// The study: its settings, the jobs that run it and what it reports. StudyDocument holds the settings
// with undo; study_form/ edits them; WarningsDock shows the warnings of reading (buildingNamed() finds the
// building that one names). Job and JobSlot run work on another thread for the whole window; open_city
// prepares a city for display; OpenOptions asks how to read files; run_estimate predicts how long a run
// takes.

#include <QObject>
#include <QUndoStack>

#include "core/study/elements/place_elements.h"

namespace noonmark {

/// The settings of the study, including its region, and where its points are if it measures points instead
/// of cells. Each change can be undone.
class StudyDocument final : public QObject {
    Q_OBJECT
public:
    explicit StudyDocument(QObject* parent = nullptr);

    [[nodiscard]] const StudySettings& settings() const { return settings_; }
    /// The points that are measured: facades, windows or a plane. None: cells of the ground or of roofs.
    [[nodiscard]] const std::optional<ElementSettings>& elements() const { return elements_; }
    [[nodiscard]] QUndoStack& undoStack() { return undoStack_; }

    /// Does nothing if nothing differs. Consecutive changes of the same `field` are one undo step.
    void change(const StudySettings& to, const QString& field) { change(to, elements_, field); }
    void change(const StudySettings& to, const std::optional<ElementSettings>& elements,
                const QString& field);

    /// Replaces the settings without undo, as after opening another city.
    void reset(const StudySettings& settings, const std::optional<ElementSettings>& elements = {});

Q_SIGNALS:
    void changed();

private:
    friend class SettingsCommand;
    void apply(const StudySettings& settings, const std::optional<ElementSettings>& elements);

    StudySettings settings_;
    std::optional<ElementSettings> elements_;
    QUndoStack undoStack_;
};

}  // namespace noonmark
