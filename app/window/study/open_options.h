#pragma once

#include <QDialog>
#include <QStringList>

#include "core/io/read_city.h"

class QLabel;

namespace noonmark {

class ReadingForm;

/// Asks how to read files that do not say everything by themselves. The window stays usable beside it.
class OpenOptions final : public QDialog {
    Q_OBJECT
public:
    explicit OpenOptions(QWidget* parent = nullptr);

    /// Shows the dialog for these files, with fields as in `settings`.
    void ask(const QStringList& files, const ReadSettings& settings);
    void setMiddle(std::optional<LonLat> middle);  ///< of the city that is open

    [[nodiscard]] QStringList files() const { return files_; }

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings settings);

private:
    QStringList files_;
    QLabel* names_;
    ReadingForm* form_;
};

}  // namespace noonmark
