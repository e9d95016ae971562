#pragma once

#include <QObject>
#include <QUndoStack>

#include "core/study/study.h"

namespace noonmark {

/// The question that the user is putting together: settings and region, each change of which can be undone.
class StudyDocument final : public QObject {
    Q_OBJECT
public:
    explicit StudyDocument(QObject* parent = nullptr);

    [[nodiscard]] const StudySettings& settings() const { return settings_; }
    [[nodiscard]] QUndoStack& undoStack() { return undoStack_; }

    /// Nothing happens when nothing differs. Changes of the same `field` that follow each other are one step
    /// of undo.
    void change(const StudySettings& to, const QString& field);

    /// A fresh start without a way back, as after opening another city.
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
