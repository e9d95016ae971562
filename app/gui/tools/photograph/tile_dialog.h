#pragma once

#include <QDialog>

#include "app/gui/tools/photograph/tile_fetch.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace noonmark {

/// Asks for the address of tiles and whose they are, and fetches them when its button is pressed, never
/// before.
class TileDialog final : public QDialog {
    Q_OBJECT
public:
    explicit TileDialog(const TileRange& range, QWidget* parent = nullptr);

    [[nodiscard]] const TileFetch& fetch() const { return fetch_; }  ///< complete once accepted
    [[nodiscard]] QString attribution() const;

    void reject() override;  ///< while it fetches: stops

private:
    void addFields();
    void addButtons();
    void follow();
    void begin();
    void showFailure(const Error& error);

    TileRange range_;
    TileFetch fetch_;
    QLineEdit* address_;
    QLineEdit* attribution_;
    QLabel* about_;
    QProgressBar* progress_;
    QPushButton* begin_ = nullptr;
};

}  // namespace noonmark
