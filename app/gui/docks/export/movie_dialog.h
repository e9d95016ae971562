#pragma once

#include <QDialog>

#include "app/gui/docks/export/movie_export.h"

class QComboBox;
class QDateEdit;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTimeEdit;

namespace noonmark {

/// Asks what a movie shows: a day, a year, or the change by a scenario. Not modal.
class MovieDialog final : public QDialog {
    Q_OBJECT
public:
    /// `first`: what the fields begin with. `comparing`: a swipe is offered, too.
    MovieDialog(const MovieChoice& first, bool comparing, QWidget* parent);

    [[nodiscard]] MovieChoice choice() const;

Q_SIGNALS:
    void chosen(noonmark::MovieChoice choice);

private:
    void makeTimes(QFormLayout& form, const MovieChoice& first, bool comparing);
    void makePicture(QFormLayout& form, const MovieChoice& first);
    void makeButtons(QFormLayout& form);
    void update();

    QComboBox* kind_;
    QDateEdit* date_;
    QTimeEdit* at_;
    QSpinBox* every_;
    QComboBox* area_;
    QComboBox* size_;
    QSpinBox* rate_;
    QLineEdit* title_;
    QLabel* length_;
};

}  // namespace noonmark
