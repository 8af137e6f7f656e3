"""Attacks mistakes that nobody thought of: chance, and small worlds that leave nothing out."""
