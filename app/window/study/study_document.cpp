#include "app/window/study/study_document.h"

#include <QUndoCommand>

namespace noonmark {

class SettingsCommand final : public QUndoCommand {
public:
    SettingsCommand(StudyDocument& document, StudySettings to, const QString& field)
        : QUndoCommand(field), document_(document), from_(document.settings()), to_(std::move(to)) {}

    void undo() override { document_.apply(from_); }
    void redo() override { document_.apply(to_); }
    int id() const override { return 1; }

    bool mergeWith(const QUndoCommand* next) override {
        if (next->text() != text() || text().startsWith(QStringLiteral("region"))) return false;
        to_ = static_cast<const SettingsCommand*>(next)->to_;
        setObsolete(to_ == from_);
        return true;
    }

private:
    StudyDocument& document_;
    StudySettings from_;
    StudySettings to_;
};

StudyDocument::StudyDocument(QObject* parent) : QObject(parent) {}

void StudyDocument::change(const StudySettings& to, const QString& field) {
    if (to == settings_) return;
    undoStack_.push(new SettingsCommand(*this, to, field));
}

void StudyDocument::reset(const StudySettings& settings) {
    undoStack_.clear();
    apply(settings);
}

void StudyDocument::apply(const StudySettings& settings) {
    settings_ = settings;
    Q_EMIT changed();
}

}  // namespace noonmark
