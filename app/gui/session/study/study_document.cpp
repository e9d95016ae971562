#include "app/gui/session/study/study_document.h"

#include <QUndoCommand>

namespace noonmark {

class SettingsCommand final : public QUndoCommand {
public:
    struct Settings {
        StudySettings study;
        std::optional<ElementSettings> elements;
        bool operator==(const Settings&) const = default;
    };

    SettingsCommand(StudyDocument& document, Settings to, const QString& field)
        : QUndoCommand(field),
          document_(document),
          from_{document.settings(), document.elements()},
          to_(std::move(to)) {}

    void undo() override { document_.apply(from_.study, from_.elements); }
    void redo() override { document_.apply(to_.study, to_.elements); }
    int id() const override { return 1; }

    bool mergeWith(const QUndoCommand* next) override {
        if (next->text() != text() || text().startsWith(QStringLiteral("region"))) return false;
        to_ = static_cast<const SettingsCommand*>(next)->to_;
        setObsolete(to_ == from_);
        return true;
    }

private:
    StudyDocument& document_;
    Settings from_;
    Settings to_;
};

StudyDocument::StudyDocument(QObject* parent) : QObject(parent) {}

void StudyDocument::change(const StudySettings& to, const std::optional<ElementSettings>& elements,
                           const QString& field) {
    if (to == settings_ && elements == elements_) return;
    undoStack_.push(new SettingsCommand(*this, {to, elements}, field));
}

void StudyDocument::reset(const StudySettings& settings, const std::optional<ElementSettings>& elements) {
    undoStack_.clear();
    apply(settings, elements);
}

void StudyDocument::apply(const StudySettings& settings, const std::optional<ElementSettings>& elements) {
    settings_ = settings;
    elements_ = elements;
    Q_EMIT changed();
}

}  // namespace noonmark
