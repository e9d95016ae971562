#pragma once

// The study: its settings, the jobs that run it and what it reports. StudyDocument holds the settings
// with undo; study_form/ edits them; WarningsDock shows the warnings of reading (warning_place finds the
// building that one names). Job and JobSlot run work on another thread for the whole window; open_city
// prepares a city for display; OpenOptions asks how to read files; run_estimate predicts how long a run
// takes.

#include <QObject>
#include <QUndoStack>

#include "core/study/study.h"

namespace noonmark {

/// The settings of the study, including its region. Each change can be undone.
class StudyDocument final : public QObject {
    Q_OBJECT
public:
    explicit StudyDocument(QObject* parent = nullptr);

    [[nodiscard]] const StudySettings& settings() const { return settings_; }
    [[nodiscard]] QUndoStack& undoStack() { return undoStack_; }

    /// Does nothing if nothing differs. Consecutive changes of the same `field` are one undo step.
    void change(const StudySettings& to, const QString& field);

    /// Replaces the settings without undo, as after opening another city.
    void reset(const StudySettings& settings);

Q_SIGNALS:
    void changed();

private:
    friend class SettingsCommand;
    void apply(const StudySettings& settings);

    StudySettings settings_;
    QUndoStack undoStack_;
};

}  // namespace noonmark
