#pragma once

#include <QObject>
#include <memory>

class QSettings;

namespace noonmark {

class MainWindow;

/// Owns the main window. Where language or units become others, makes another window around the same work,
/// as texts that are shown do not change by themselves: every text, table, scale and field is then new.
class WindowRenewal final : public QObject {
    Q_OBJECT
public:
    explicit WindowRenewal(QSettings& settings);  ///< `settings` must outlive it
    ~WindowRenewal() override;

    [[nodiscard]] MainWindow& window() { return *window_; }  ///< until it is renewed

Q_SIGNALS:
    void renewed();  ///< window() is another one

private:
    void renew();
    void adopt(std::unique_ptr<MainWindow> window);

    QSettings& settings_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace noonmark
