#pragma once

#include <QWidget>
#include <optional>

#include "app/gui/docks/review/glazing/verdict_tiles.h"

class QComboBox;

namespace noonmark {

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
