// In a worker of its own: receives the module once, then questions, and posts answers.
