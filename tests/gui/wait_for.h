#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>

namespace noonmark::test {

/// Lets the application work until `condition` holds; false when it does not within the limit, which is far
/// above what is needed.
template <class Condition>
bool waitFor(Condition condition, int limitMs = 60000) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
        if (clock.elapsed() > limitMs) return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
}

}  // namespace noonmark::test
