"""Exact questions about one robot and one obstacle: when do they meet, how near do they come?"""
