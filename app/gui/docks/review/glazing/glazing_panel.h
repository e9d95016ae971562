#pragma once

#include <QWidget>
#include <optional>

#include "app/gui/docks/review/glazing/verdict_links.h"
#include "core/study/elements/place_elements.h"

class QComboBox;

namespace noonmark {

class ElementForm;

/// Which windows a rule is evaluated on: one in each bay and storey of facades, or those of a file.
class GlazingForm final : public QWidget {
    Q_OBJECT
public:
    explicit GlazingForm(QWidget* parent = nullptr);

    void show(const ElementSettings& windows);  ///< without a signal
    void setBuilding(const QString& id);        ///< the selected building; empty: none
    [[nodiscard]] ElementForm& elements() { return *form_; }

Q_SIGNALS:
    void edited(noonmark::ElementSettings windows);

private:
    QComboBox* source_;
    ElementForm* form_;
};

class GlazingTable;

/// The table of windows with their verdicts, and above it the choice of what the view shows of them.
class GlazingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit GlazingPanel(QWidget* parent = nullptr);

    [[nodiscard]] GlazingTable& table() { return *table_; }
    [[nodiscard]] ShownVerdicts shown() const;
    void setShown(ShownVerdicts shown);  ///< as if the user had chosen it
    /// Another result is shown instead, until bringBack() or a choice of the user.
    void putAway();
    void bringBack();

Q_SIGNALS:
    void shownChanged();

private:
    QComboBox* choice_;
    GlazingTable* table_;
    std::optional<ShownVerdicts> away_;  ///< what bringBack() shows
};

}  // namespace noonmark
