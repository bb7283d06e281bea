#pragma once
/// Problems whose W is given by its entries.

#include "delassus/problem.h"
#include "tests/support/random_problems.h"

namespace delassus::test {

DelassusMatrix matrix(const MatrixXd& W);

/// Contacts of all modes that nothing couples.
Problem loneContacts(int n, Random& random);

}  // namespace delassus::test
